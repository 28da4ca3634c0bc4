// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/edge_chain.h"

#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kBeyondEnd_px = 1.0;
/// Minimum dP(i) of a reliable piece, in ground pixels: 0.12 m in Chio and Wang 2000, section 4,
/// whose ground pixel is 0.24 m.
constexpr double kMinPieceGsd = 0.5;

/// The line of a segment: n . y = c, |n| = 1, and its start.
struct RightLine {
  Eigen::Vector2d start, along, normal;
  double c = 0.0, length_px = 0.0;

  explicit RightLine(const Segment2& s)
      : start(s.start),
        along(ridgeline::along(s)),
        normal(normal_of(along)),
        c(normal.dot(s.start)),
        length_px(length(s)) {}

  [[nodiscard]] bool holds(const Eigen::Vector2d& y) const {
    const double t = along.dot(y - start);
    return t >= -kBeyondEnd_px && t <= length_px + kBeyondEnd_px;
  }
};

std::vector<ChainPoint> chain_points(const EpipolarTransfer& right_from_left,
                                     std::span<const SearchedPoint> left_points,
                                     const RightLine& right) {
  std::vector<ChainPoint> points;
  points.reserve(left_points.size());
  for (const SearchedPoint& left : left_points) {
    const double z_m = left.stretch.height_on(right.normal, right.c);
    if (!std::isfinite(z_m) || !right.holds(left.stretch.at(z_m))) continue;
    points.push_back({left.point.step, right_from_left.object_point(left.point.x_px, z_m)});
  }
  return points;
}

std::vector<EdgePiece> pieces_of(std::span<const ChainPoint> points, double limit_m) {
  std::vector<EdgePiece> pieces;
  pieces.reserve(points.size());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (points[i + 1].step != points[i].step + 1) continue;
    const Eigen::Vector3d d = points[i + 1].x_in_local - points[i].x_in_local;
    EdgePiece piece;
    piece.first = static_cast<int>(i);
    piece.run_m = d.head<2>().norm();
    piece.rate = d.z() / piece.run_m;
    piece.reliable = piece.run_m >= limit_m && std::isfinite(piece.rate);
    pieces.push_back(piece);
  }
  return pieces;
}

void summarise_pieces(EdgeChain& chain) {
  ChainSummary& summary = chain.summary;
  double sum = 0.0;
  Eigen::Vector2d way = Eigen::Vector2d::Zero();
  for (const EdgePiece& piece : chain.pieces) {
    if (!piece.reliable) continue;
    ++summary.n_reliable;
    sum += piece.rate;
    way +=
        (chain.points[piece.first + 1].x_in_local - chain.points[piece.first].x_in_local).head<2>();
  }
  if (summary.n_reliable == 0) return;
  summary.mean_rate = sum / summary.n_reliable;
  summary.azimuth_rad = std::atan2(way.x(), way.y());
  double squares = 0.0;
  for (const EdgePiece& piece : chain.pieces) {
    if (piece.reliable)
      squares += (piece.rate - summary.mean_rate) * (piece.rate - summary.mean_rate);
  }
  if (summary.n_reliable > 1) summary.rate_sigma = std::sqrt(squares / (summary.n_reliable - 1));
}

/// Variance of a segment's line perpendicular to itself, at a point.
double variance_across_px2(const UncertainSegment2& s, const Eigen::Vector2d& x) {
  const double t = along(s.segment).dot(x - s.centroid_px);
  return s.sigma_q_px * s.sigma_q_px + t * t * s.sigma_phi_rad * s.sigma_phi_rad;
}

void summarise_heights(const EpipolarTransfer& right_from_left,
                       std::span<const SearchedPoint> left_points,
                       const UncertainSegment2& left,
                       const UncertainSegment2& right,
                       EdgeChain& chain) {
  double sum = 0.0;
  for (const ChainPoint& p : chain.points) sum += p.x_in_local.z();
  chain.summary.mean_height_m = sum / static_cast<double>(chain.points.size());

  const RightLine line(right.segment);
  const int middle = chain.points[chain.points.size() / 2].step;
  const auto point =
      std::ranges::find(left_points, middle, [](const SearchedPoint& p) { return p.point.step; });
  const Eigen::Vector2d x = point->point.x_px;
  const double z_m = point->stretch.height_on(line.normal, line.c);
  const double moved_m =
      right_from_left.stretch(x + normal(left.segment)).height_on(line.normal, line.c);
  chain.summary.height_per_px_m = std::abs(moved_m - z_m);
  // Change of the height of the right line's crossing with the epipolar line if the right line
  // moves by 1 px along its normal.
  const double right_per_px_m = 1.0 / std::abs(line.normal.dot(point->stretch.derivative(z_m)));
  const Eigen::Vector2d y = point->stretch.at(z_m);
  chain.summary.height_sigma_m = std::sqrt(
      chain.summary.height_per_px_m * chain.summary.height_per_px_m * variance_across_px2(left, x) +
      right_per_px_m * right_per_px_m * variance_across_px2(right, y));
}

}  // namespace

std::vector<SearchedPoint> searched_points(const EpipolarTransfer& right_from_left,
                                           const ImageSampler& left_image,
                                           const EdgeSegment& left) {
  return transformed(edge_points(left_image, left), [&](const EdgePoint& point) -> SearchedPoint {
    return {point, right_from_left.stretch(point.x_px)};
  });
}

EdgeChain edge_chain(const EpipolarTransfer& right_from_left,
                     std::span<const SearchedPoint> left_points,
                     const UncertainSegment2& left,
                     const UncertainSegment2& right,
                     double gsd_m) {
  EdgeChain chain;
  chain.points = chain_points(right_from_left, left_points, RightLine(right.segment));
  if (chain.points.empty()) return chain;
  chain.pieces = pieces_of(chain.points, kMinPieceGsd * gsd_m);
  summarise_pieces(chain);
  summarise_heights(right_from_left, left_points, left, right, chain);
  return chain;
}

double expected_rate_sigma(const ChainSummary& chain, double gsd_m, double edge_sigma_px) {
  return M_SQRT2 * edge_sigma_px * chain.height_per_px_m / gsd_m;
}

double expected_mean_rate_sigma(const ChainSummary& chain, double gsd_m, double edge_sigma_px) {
  return expected_rate_sigma(chain, gsd_m, edge_sigma_px) / std::max(1, chain.n_reliable);
}

}  // namespace ridgeline::reconstruct
