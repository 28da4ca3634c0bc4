// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/wireframe.h"

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/Core>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace ridgeline::evaluate {
namespace {

namespace bg = boost::geometry;
using EndPoint = bg::model::point<double, 3, bg::cs::cartesian>;
using Entry = std::pair<EndPoint, std::size_t>;
using Tree = bg::index::rtree<Entry, bg::index::rstar<16>>;

EndPoint point_of(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

/// Calls `visit(index)`, in the order of the indices, for the entries within `radius_m` of x on
/// each axis.
template <typename Visit>
void for_each_within(const Tree& tree,
                     const Eigen::Vector3d& x,
                     double radius_m,
                     const Visit& visit) {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(radius_m);
  const bg::model::box<EndPoint> box(point_of(x - reach), point_of(x + reach));
  std::vector<Entry> entries;
  tree.query(bg::index::intersects(box), std::back_inserter(entries));
  std::ranges::sort(entries, {}, &Entry::second);
  for (const Entry& entry : entries) visit(entry.second);
}

struct Wireframe {
  std::vector<Eigen::Vector3d> corners;
  std::vector<std::array<std::size_t, 2>> edges;  ///< by the indices of their two corners
};

Wireframe wireframe_of(std::span<const Segment3> segments) {
  constexpr double kSameCorner_m = 0.01;
  Wireframe frame;
  Tree tree;
  const auto corner_at = [&](const Eigen::Vector3d& x) {
    std::size_t corner = frame.corners.size();
    for_each_within(tree, x, kSameCorner_m, [&](std::size_t i) {
      if ((frame.corners[i] - x).norm() <= kSameCorner_m) corner = std::min(corner, i);
    });
    if (corner == frame.corners.size()) {
      frame.corners.push_back(x);
      tree.insert({point_of(x), corner});
    }
    return corner;
  };
  for (const Segment3& s : segments) {
    check(all_finite(s), "wireframe: a line is not finite");
    const std::size_t start = corner_at(s.start);
    frame.edges.push_back({start, corner_at(s.end)});
  }
  return frame;
}

/// A corner and a true corner that may match.
struct CornerPair {
  double distance_m;
  std::size_t corner, true_corner;
};

/// All pairs closer than or at a given distance, nearest first.
std::vector<CornerPair> pairs_within(const Wireframe& frame,
                                     const Wireframe& truth,
                                     double limit_m) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < truth.corners.size(); ++i)
    entries.emplace_back(point_of(truth.corners[i]), i);
  const Tree tree(entries.begin(), entries.end());
  std::vector<CornerPair> pairs;
  for (std::size_t i = 0; i < frame.corners.size(); ++i) {
    for_each_within(tree, frame.corners[i], limit_m, [&](std::size_t k) {
      const double distance_m = (frame.corners[i] - truth.corners[k]).norm();
      if (distance_m <= limit_m) pairs.push_back({distance_m, i, k});
    });
  }
  std::ranges::sort(pairs, {}, [](const CornerPair& p) {
    return std::tuple(p.distance_m, p.corner, p.true_corner);
  });
  return pairs;
}

std::array<std::size_t, 2> ordered(std::size_t a, std::size_t b) {
  return {std::min(a, b), std::max(a, b)};
}

WireframeScore score_at(double threshold_m,
                        const std::vector<CornerPair>& pairs,
                        const Wireframe& frame,
                        const Wireframe& truth) {
  WireframeScore score{
      .threshold_m = threshold_m, .corners = {}, .edges = {}, .mean_corner_offset_m = {}};
  std::map<std::size_t, std::size_t> true_of;
  std::set<std::size_t> taken;
  double sum_m = 0.0;
  for (const CornerPair& pair : pairs) {
    if (pair.distance_m > threshold_m) break;
    if (true_of.contains(pair.corner) || taken.contains(pair.true_corner)) continue;
    true_of[pair.corner] = pair.true_corner;
    taken.insert(pair.true_corner);
    sum_m += pair.distance_m;
  }
  score.corners = {frame.corners.size(), truth.corners.size(), true_of.size()};
  if (!true_of.empty()) score.mean_corner_offset_m = sum_m / static_cast<double>(true_of.size());

  std::set<std::array<std::size_t, 2>> missing;
  for (const auto& [a, b] : truth.edges) missing.insert(ordered(a, b));
  score.edges = {frame.edges.size(), missing.size(), 0};
  for (const auto& [a, b] : frame.edges) {
    const auto start = true_of.find(a);
    const auto end = true_of.find(b);
    if (start == true_of.end() || end == true_of.end()) continue;
    score.edges.n_matched += missing.erase(ordered(start->second, end->second));
  }
  return score;
}

}  // namespace

std::optional<double> DetectionScore::precision() const {
  if (n_found == 0) return std::nullopt;
  return static_cast<double>(n_matched) / static_cast<double>(n_found);
}

std::optional<double> DetectionScore::recall() const {
  if (n_true == 0) return std::nullopt;
  return static_cast<double>(n_matched) / static_cast<double>(n_true);
}

std::optional<double> DetectionScore::f1() const {
  if (n_found == 0 || n_true == 0) return std::nullopt;
  return 2.0 * static_cast<double>(n_matched) / static_cast<double>(n_found + n_true);
}

std::vector<WireframeScore> wireframe_scores(std::span<const Segment3> lines,
                                             std::span<const Segment3> references) {
  const Wireframe frame = wireframe_of(lines);
  const Wireframe truth = wireframe_of(references);
  const std::vector<CornerPair> pairs =
      pairs_within(frame, truth, std::ranges::max(kWireframeThresholds_m));
  return transformed(kWireframeThresholds_m, [&](const double threshold_m) {
    return score_at(threshold_m, pairs, frame, truth);
  });
}

}  // namespace ridgeline::evaluate
