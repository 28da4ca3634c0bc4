// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/constraints.h"

#include "reconstruct/geometry/degrees.h"

#include <Eigen/LU>

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

// Spreads of the geometric constraints between correct pairs, for surfaces inclined by up to 45
// degrees and a base-to-height ratio of 0.26. The argument `spread` multiplies them.
constexpr double kAngleSigma_rad = 5.0 * kRadPerDeg;
constexpr double kDirectionSigma_rad = 8.0 * kRadPerDeg;
constexpr double kExtentLogSigma = 0.15;

double gaussian(double residual, double sigma) {
  return std::exp(-0.5 * (residual / sigma) * (residual / sigma));
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Oriented angle from a to b, (-pi, pi].
double turn_rad(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::atan2(cross(a, b), a.dot(b));
}

double wrapped_rad(double angle) { return std::remainder(angle, 2.0 * M_PI); }

Eigen::Vector2d direction(const Segment2& s) { return s.end - s.start; }

double mean_end_distance(const PairShape& pair) {
  return 0.25 *
         ((pair.first.start - pair.second.start).norm() +
          (pair.first.start - pair.second.end).norm() +
          (pair.first.end - pair.second.start).norm() + (pair.first.end - pair.second.end).norm());
}

}  // namespace

std::optional<double> epipolar_similarity(double distance_px, double sigma_px) {
  return gaussian(distance_px, std::hypot(sigma_px, kMeetSigma_px));
}

double intersection_sigma_px(const UncertainSegment2& a,
                             const UncertainSegment2& b,
                             const Eigen::Vector2d& intersection,
                             const Eigen::Vector2d& direction_of_interest) {
  // x solves n_i x = c_i, so an error of line i across itself at x moves x along column i of N^-1.
  Eigen::Matrix2d normals;
  Eigen::Vector2d sigma_across;
  int row = 0;
  for (const UncertainSegment2* s : {&a, &b}) {
    const Eigen::Vector2d u = direction(s->segment).normalized();
    normals.row(row) = Eigen::RowVector2d(-u.y(), u.x());
    sigma_across[row++] =
        std::hypot(s->sigma_q_px, s->sigma_phi_rad * u.dot(intersection - s->centroid_px));
  }
  const Eigen::RowVector2d shift = direction_of_interest.transpose() * normals.inverse();
  return shift.cwiseProduct(sigma_across.transpose()).norm();
}

std::optional<double> angle_similarity(const PairShape& left,
                                       const PairShape& right,
                                       double spread) {
  const double a = turn_rad(direction(left.first), direction(left.second));
  const double b = turn_rad(direction(right.first), direction(right.second));
  return gaussian(wrapped_rad(a - b), spread * kAngleSigma_rad);
}

std::optional<double> direction_similarity(const PairShape& left,
                                           const PairShape& right,
                                           double spread) {
  constexpr double kSamePlace_px = 1.0;
  if (!left.clipped || !right.clipped) return std::nullopt;
  const Eigen::Vector2d a = midpoint(left.second) - midpoint(left.first);
  const Eigen::Vector2d b = midpoint(right.second) - midpoint(right.first);
  if (a.norm() < kSamePlace_px || b.norm() < kSamePlace_px) return std::nullopt;
  return gaussian(
      wrapped_rad(turn_rad(direction(left.first), a) - turn_rad(direction(right.first), b)),
      spread * kDirectionSigma_rad);
}

std::optional<double> extent_similarity(const PairShape& left,
                                        const PairShape& right,
                                        double spread) {
  if (!left.clipped || !right.clipped) return std::nullopt;
  const double a = (length(left.first) + length(left.second)) / mean_end_distance(left);
  const double b = (length(right.first) + length(right.second)) / mean_end_distance(right);
  return gaussian(std::log(a / b), spread * kExtentLogSigma);
}

}  // namespace ridgeline::reconstruct
