// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/linked_line.h"

#include "reconstruct/geometry/transformed.h"
#include "reconstruct/match/chio_wang2000/edge_chain.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

/// Neighbouring edge pixels share the blur: n of them count as n / 2.8 independent ones, the value
/// that edge_noise() assumes for aerial images.
constexpr double kCorrelation = 2.8;

void add_reliable_points(const EdgeChain& chain, std::vector<ChainPoint>& points) {
  int last = -1;
  for (const EdgePiece& piece : chain.pieces) {
    if (!piece.reliable) continue;
    for (const int i : {piece.first, piece.first + 1}) {
      if (i <= last) continue;
      points.push_back(chain.points[i]);
      last = i;
    }
  }
}

/// The derivatives of the ends of a line with respect to the shift (px, at the centroid) and the
/// direction (rad) of the right line.
Eigen::Matrix<double, 6, 2> by_right_line(const Segment3& line,
                                          const SearchedPair& pair,
                                          const UncertainSegment2& right) {
  const Eigen::Vector2d u = along(right.segment);
  Eigen::Matrix<double, 6, 2> jacobian;
  for (const Eigen::Index end : {0, 1}) {
    const Eigen::Vector3d& x = end == 0 ? line.start : line.end;
    const Stretch stretch =
        pair.search.right_from_left.stretch(project(pair.left.image_from_local, x));
    const double height_per_px_m = 1.0 / normal_of(u).dot(stretch.derivative(x.z()));
    const Eigen::Vector3d ray = x - pair.search.right_from_left.centre();
    const Eigen::Vector3d per_px = ray / ray.z() * height_per_px_m;
    const double t_px = u.dot(stretch.at(x.z()) - right.centroid_px);
    jacobian.block<3, 1>(3 * end, 0) = per_px;
    jacobian.block<3, 1>(3 * end, 1) = t_px * per_px;
  }
  return jacobian;
}

}  // namespace

std::optional<FittedLine> fit_line(std::span<const Eigen::Vector3d> points, double correlation) {
  constexpr std::size_t kMinPoints = 3;
  if (points.size() < kMinPoints) return std::nullopt;
  const auto n = static_cast<double>(points.size());
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& x : points) centroid += x / n;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& x : points) {
    moments += (x - centroid) * (x - centroid).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments);
  const double spread = axes.eigenvalues().z();
  if (!(spread > 0.0)) return std::nullopt;
  Eigen::Vector3d along = axes.eigenvectors().col(2);
  if (along.dot(points.back() - points.front()) < 0.0) along = -along;

  double first = HUGE_VAL;
  double last = -HUGE_VAL;
  for (const Eigen::Vector3d& x : points) {
    first = std::min(first, along.dot(x - centroid));
    last = std::max(last, along.dot(x - centroid));
  }
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along * along.transpose();
  const Eigen::Matrix3d scatter = across * moments * across * (correlation / (n - 2.0));

  FittedLine line;
  line.segment = {centroid + first * along, centroid + last * along};
  const auto block = [&](double s, double t) { return scatter * (1.0 / n + s * t / spread); };
  line.cov_m2 << block(first, first), block(first, last), block(last, first), block(last, last);
  return line;
}

std::optional<FittedLine> line_through_links(int left_id,
                                             std::span<const int> right_ids,
                                             const SearchedPair& pair,
                                             double gsd_m) {
  const EdgeSegment& edge = pair.left.segments[left_id];
  const std::vector<SearchedPoint> searched =
      searched_points(pair.search.right_from_left, ImageSampler(pair.left.image), edge);
  std::vector<ChainPoint> on_line;
  for (const int id : right_ids) {
    add_reliable_points(edge_chain(pair.search.right_from_left, searched, edge.line,
                                   pair.right.segments[id].line, gsd_m),
                        on_line);
  }
  // fragments are linked in any order; the line has the direction of the left segment
  std::ranges::stable_sort(on_line, {}, &ChainPoint::step);
  std::optional<FittedLine> line =
      fit_line(transformed(on_line, &ChainPoint::x_in_local), kCorrelation);
  if (!line) return line;
  const UncertainSegment2& counterpart = pair.right.segments[right_ids.front()].line;
  const Eigen::Matrix<double, 6, 2> jacobian = by_right_line(line->segment, pair, counterpart);
  const Eigen::Vector2d variances(counterpart.sigma_q_px * counterpart.sigma_q_px,
                                  counterpart.sigma_phi_rad * counterpart.sigma_phi_rad);
  line->cov_m2 += jacobian * variances.asDiagonal() * jacobian.transpose();
  return line;
}

}  // namespace ridgeline::reconstruct
