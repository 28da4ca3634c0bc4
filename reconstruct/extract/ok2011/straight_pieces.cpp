// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/straight_pieces.h"

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Eigenvalues>

namespace ridgeline::reconstruct {
namespace {

/// Index of the point farthest from the chord between the first and the last point; never one of
/// these two.
int farthest_from_chord(std::span<const Eigen::Vector2d> points) {
  Eigen::Vector2d chord = points.back() - points.front();
  if (chord.norm() == 0.0) chord = points[points.size() / 2] - points.front();
  const Eigen::Vector2d normal = normal_of(chord);
  int farthest = 1;
  double largest = -1.0;
  for (int i = 1; i + 1 < static_cast<int>(points.size()); ++i) {
    const double distance = std::abs(normal.dot(points[i] - points.front()));
    if (distance > largest) {
      largest = distance;
      farthest = i;
    }
  }
  return farthest;
}

}  // namespace

PrincipalAxes principal_axes(std::span<const Eigen::Vector2d> points) {
  check(!points.empty(), "principal_axes: no points");
  PrincipalAxes axes{.centroid = Eigen::Vector2d::Zero(), .along = Eigen::Vector2d::UnitX()};
  for (const Eigen::Vector2d& x : points) axes.centroid += x;
  axes.centroid /= static_cast<double>(points.size());
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& x : points) {
    scatter += (x - axes.centroid) * (x - axes.centroid).transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(scatter / static_cast<double>(points.size()));
  if (solver.eigenvalues()[1] > 0.0) axes.along = solver.eigenvectors().col(1).normalized();
  if (axes.along.dot(points.back() - points.front()) < 0.0) axes.along = -axes.along;
  axes.lambda_min = std::max(0.0, solver.eigenvalues()[0]);
  for (const Eigen::Vector2d& x : points) {
    const double distance = std::abs(normal_of(axes.along).dot(x - axes.centroid));
    axes.max_distance = std::max(axes.max_distance, distance);
  }
  return axes;
}

std::vector<Piece> straight_pieces(std::span<const Eigen::Vector2d> points,
                                   const ExtractOptions& options) {
  std::vector<Piece> pieces;
  std::vector<Piece> open{{0, static_cast<int>(points.size())}};
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    const auto run = points.subspan(piece.first, piece.last - piece.first);
    // Each edge pixel accounts for at most sqrt(2) px of the length.
    if (static_cast<double>(run.size()) * M_SQRT2 < options.min_length_px) continue;
    const PrincipalAxes axes = principal_axes(run);
    if (axes.lambda_min <= kMaxLambdaMinPx2 && axes.max_distance <= options.max_deviation_px) {
      if ((run.back() - run.front()).norm() >= options.min_length_px) pieces.push_back(piece);
      continue;
    }
    const int cut = piece.first + farthest_from_chord(run);
    open.push_back({cut, piece.last});
    open.push_back({piece.first, cut + 1});
  }
  return pieces;
}

}  // namespace ridgeline::reconstruct
