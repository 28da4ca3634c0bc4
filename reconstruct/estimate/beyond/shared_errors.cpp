// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/shared_errors.h"

#include "reconstruct/estimate/ok2011/adjust_line.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/Geometry>

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kAlike = 0.1;      // scale^2 for equal profiles
constexpr double kDifferent = 6.0;  // increase of scale^2 for profiles with nothing in common
constexpr double kHalfway = 0.02;   // loss of correlation at half this increase

constexpr double kSharedShift_px = 0.1;
constexpr double kSharedTurn_px = 0.03;

/// The shift of a point whose image moves by one pixel across the line.
Eigen::Vector3d across_per_px(const ProjectionMatrix& image_from_local,
                              const Eigen::Vector3d& x,
                              const Eigen::Vector3d& along) {
  const Eigen::Vector3d ray = x - projection_centre(image_from_local).hnormalized();
  const Eigen::Vector3d across = along.cross(ray).normalized();
  const Eigen::Vector3d image = image_from_local * x.homogeneous();
  const Eigen::Vector3d by_across = image_from_local.leftCols<3>() * across;
  const Eigen::Vector2d px_per_m =
      (by_across.head<2>() - image.hnormalized() * by_across.z()) / image.z();
  return across / px_per_m.norm();
}

}  // namespace

double own_sigma_scale(double similarity) {
  const double loss = 1.0 - similarity;
  return std::sqrt(kAlike + kDifferent * loss / (loss + kHalfway));
}

double agreement_sigma_scale(const ObservedTrack& line) {
  constexpr double kPriorFreedoms = 4.0;  // plus 2 N - 4 of the adjustment: 2 N in total
  if (line.observations.size() < 3) return 1.0;
  const auto adjusted = adjust_line(transformed(line.observations, &ObservedLine::plane), {});
  if (!adjusted || !adjusted->full_rank) return 1.0;
  const double n_views = static_cast<double>(line.observations.size());
  return std::sqrt((kPriorFreedoms + adjusted->omega) / (2.0 * n_views));
}

void add_shared_error(const ProjectionMatrix& left_from_local, ReconstructedLine& line) {
  if (!line.covariance_m2) return;
  const Segment3& segment = *line.segment_in_local;
  const Eigen::Vector3d along = segment.end - segment.start;
  const Eigen::Vector3d at_start = across_per_px(left_from_local, segment.start, along);
  const Eigen::Vector3d at_end = across_per_px(left_from_local, segment.end, along);
  Vector6d shift, turn;
  shift << at_start, at_end;
  turn << at_start, -at_end;
  *line.covariance_m2 += kSharedShift_px * kSharedShift_px * shift * shift.transpose() +
                         kSharedTurn_px * kSharedTurn_px * turn * turn.transpose();
}

}  // namespace ridgeline::reconstruct
