// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/ok2011/estimate/line_geometry.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

Segment3 local_from_conditioned(const ObjectConditioning& object, const Segment3& s) {
  return {object.local_from_conditioned(s.start), object.local_from_conditioned(s.end)};
}

/// Whether the ends of the left segment lie so far beyond a short right one that the line is no
/// longer known there, while between the right ends it is better known.
bool is_extrapolated(const UncertainSegment3& left,
                     const UncertainSegment3& right,
                     double scale_m,
                     double max_end_sigma_m) {
  const double sigma_m = scale_m * largest_sigma_z_m(left.cov);
  return sigma_m > max_end_sigma_m && scale_m * largest_sigma_z_m(right.cov) < sigma_m;
}

}  // namespace

double largest_sigma_z_m(const Matrix6d& cov_m2) {
  return std::sqrt(std::max(cov_m2(2, 2), cov_m2(5, 5)));
}

bool assign_geometry(const StereoViews& stereo,
                     const ObservedPair& seen,
                     const UncertainLine3& estimate,
                     double max_end_sigma_m,
                     ReconstructedLine& result) {
  const std::array<ConditionedView, 2>& views = stereo.views;
  const auto left = endpoints(estimate, views[0], seen[0], views);
  if (!left) return false;
  const auto right = endpoints(estimate, views[1], seen[1], views);
  const ObjectConditioning& object = stereo.object;
  result.between_right_ends = right && result.line_class == LineClass::kNotAligned &&
                              (result.between_right_ends ||
                               is_extrapolated(*left, *right, object.scale_m, max_end_sigma_m));
  const UncertainSegment3& used = result.between_right_ends ? *right : *left;
  result.segment_in_local = local_from_conditioned(object, used.segment);
  result.covariance_m2 = object.scale_m * object.scale_m * used.cov;
  result.right_segment_in_local.reset();
  if (right) result.right_segment_in_local = local_from_conditioned(object, right->segment);
  return true;
}

}  // namespace ridgeline::reconstruct
