// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/corners.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/disjoint_sets.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace ridgeline::evaluate {
namespace {

constexpr double kMinCornerAngle_deg = 15.0;
constexpr double kMaxCornerHeight_m = 0.3;  ///< between two lines that cross in plan
/// How far an end may be moved: the border of random points is cut short by this much at corners.
constexpr double kCornerReachSpacings = 3.0;

using EdgeEnd = std::size_t;  ///< 2 * edge + (0: start, 1: end)

Eigen::Vector3d& place_of(std::vector<FoundEdge>& edges, EdgeEnd end) {
  Segment3& segment = edges[end / 2].edge.segment;
  return end % 2 == 0 ? segment.start : segment.end;
}

/// The middle between two lines where they cross in plan; empty if they pass above each other.
std::optional<Eigen::Vector3d> crossing(const Segment3& a, const Segment3& b) {
  const auto x = intersection(plan(a), plan(b), kMinCornerAngle_deg * kRadPerDeg);
  if (!x) return std::nullopt;
  const double za = point_at(a, parameter_along(plan(a), *x)).z();
  const double zb = point_at(b, parameter_along(plan(b), *x)).z();
  if (std::abs(za - zb) > kMaxCornerHeight_m) return std::nullopt;
  return Eigen::Vector3d(x->x(), x->y(), 0.5 * (za + zb));
}

class Corners {
 public:
  explicit Corners(std::vector<FoundEdge>& edges) : edges_(edges), sets_(2 * edges.size()) {}

  void find() {
    std::map<std::pair<std::size_t, int>, std::vector<std::size_t>> of_plane;
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (const std::size_t plane : edges_[e].edge.planes)
        of_plane[{plane, edges_[e].level}].push_back(e);
    for (const auto& [plane, members] : of_plane) {
      for (std::size_t i = 0; i < members.size(); ++i)
        for (std::size_t k = i + 1; k < members.size(); ++k) add_pair(members[i], members[k]);
    }
    join_nearest();
    for (const auto& [name, ends] : groups()) move(ends);
  }

 private:
  struct CornerPair {
    double distance_m;  ///< by which the farther end is moved
    EdgeEnd a, b;
  };

  void add_pair(std::size_t a, std::size_t b) {
    const auto x = crossing(edges_[a].edge.segment, edges_[b].edge.segment);
    if (!x) return;
    const double reach_m =
        kCornerReachSpacings * std::max(edges_[a].spacing_m, edges_[b].spacing_m);
    const EdgeEnd end_a = nearer_end(a, *x), end_b = nearer_end(b, *x);
    const double distance_m =
        std::max((place_of(edges_, end_a) - *x).norm(), (place_of(edges_, end_b) - *x).norm());
    if (distance_m <= reach_m) meetings_.push_back({distance_m, end_a, end_b});
  }

  EdgeEnd nearer_end(std::size_t e, const Eigen::Vector3d& x) const {
    const Segment3& s = edges_[e].edge.segment;
    return 2 * e + ((s.start - x).squaredNorm() <= (s.end - x).squaredNorm() ? 0 : 1);
  }

  /// Joins ends, the nearest first, but never both ends of one edge.
  void join_nearest() {
    std::ranges::sort(meetings_, {},
                      [](const CornerPair& m) { return std::tuple(m.distance_m, m.a, m.b); });
    std::map<std::size_t, std::vector<EdgeEnd>> members;
    const auto ends_of = [&](std::size_t name) -> std::vector<EdgeEnd>& {
      std::vector<EdgeEnd>& ends = members[name];
      if (ends.empty()) ends.push_back(name);
      return ends;
    };
    for (const CornerPair& m : meetings_) {
      const std::size_t a = sets_.name_of(m.a), b = sets_.name_of(m.b);
      if (a == b) continue;
      const std::vector<EdgeEnd> of_a = ends_of(a), of_b = ends_of(b);
      const bool closes = std::ranges::any_of(
          of_a, [&](EdgeEnd x) { return std::ranges::find(of_b, x ^ 1U) != of_b.end(); });
      if (closes) continue;
      sets_.join(a, b);
      std::vector<EdgeEnd> all = of_a;
      all.insert(all.end(), of_b.begin(), of_b.end());
      members[sets_.name_of(a)] = std::move(all);
    }
  }

  std::map<std::size_t, std::vector<EdgeEnd>> groups() {
    std::map<std::size_t, std::vector<EdgeEnd>> result;
    for (EdgeEnd end = 0; end < 2 * edges_.size(); ++end) result[sets_.name_of(end)].push_back(end);
    std::erase_if(result, [](const auto& group) { return group.second.size() < 2; });
    return result;
  }

  double sigma_m(EdgeEnd end) {
    const EdgeModel& model = edges_[end / 2].model;
    return std::sqrt(model.variance_m2(model.direction.dot(place_of(edges_, end) - model.middle)));
  }

  void move(const std::vector<EdgeEnd>& ends) {
    constexpr double kMinSigma_m = 1e-6, kMaxOff_m = 0.1, kMinShare = 0.5;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const Eigen::Vector3d x0 = place_of(edges_, ends.front());
    for (const EdgeEnd end : ends) {
      const EdgeModel& model = edges_[end / 2].model;
      const Eigen::Matrix3d across =
          (Eigen::Matrix3d::Identity() - model.direction * model.direction.transpose()) /
          std::pow(std::max(sigma_m(end), kMinSigma_m), 2);
      information += across;
      sum += across * (model.middle - x0);
    }
    const Eigen::Matrix3d covariance = information.inverse();
    const Eigen::Vector3d corner = x0 + covariance * sum;
    for (const EdgeEnd end : ends) {
      FoundEdge& found = edges_[end / 2];
      const Eigen::Vector3d d = found.model.direction;
      const double s = d.dot(corner - found.model.middle);
      const Eigen::Vector3d foot = found.model.middle + s * d;
      const double length_m = length(found.edge.segment);
      const Eigen::Vector3d other = place_of(edges_, end ^ 1U);
      const double new_length_m = (end % 2 == 0 ? -1.0 : 1.0) * d.dot(foot - other);
      if (new_length_m < kMinShare * length_m) continue;
      const bool meets = (corner - foot).norm() <= std::max(3.0 * sigma_m(end), kMaxOff_m);
      place_of(edges_, end) = meets ? corner : foot;
      found.along_m2[end % 2] = d.dot(covariance * d);
    }
  }

  std::vector<FoundEdge>& edges_;
  DisjointSets sets_;
  std::vector<CornerPair> meetings_;
};

}  // namespace

void meet_at_corners(std::vector<FoundEdge>& edges) { Corners(edges).find(); }

}  // namespace ridgeline::evaluate
