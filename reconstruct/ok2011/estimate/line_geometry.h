// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/ok2011/estimate/endpoints.h"
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"
#include "reconstruct/views/conditioned_view.h"

namespace ridgeline::reconstruct {

/// Larger height sigma of the two ends.
double largest_sigma_z_m(const Matrix6d& cov_m2);

/// Replaces the result's geometry by the part of the line that is seen between the ends of its left
/// segment, or of a not_aligned line whose end is less certain than that (height), where the right ones are more certain,
/// between these; false, and nothing is
/// changed, if a camera does not see it.
bool assign_geometry(const StereoViews& stereo,
                     const ObservedPair& seen,
                     const UncertainLine3& estimate,
                     double max_end_sigma_m,
                     ReconstructedLine& result);

}  // namespace ridgeline::reconstruct
