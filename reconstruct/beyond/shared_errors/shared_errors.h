// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"

namespace ridgeline::reconstruct {

// Where an edge is found has two errors. What both images show alike (the surfaces on both sides, light,
// sharpening) moves it alike in both: the line moves across the rays, its depth stays. What they show
// differently moves it in one of them: the depth of the line is wrong.

/// By which the sigmas across both edges of a match are to be multiplied. Two edges between the same
/// surfaces have nearly the same error, so that they agree far better than each is known; where one image
/// shows another surface than the other one, they agree far worse:
///   scale^2 = 0.1 + 6 (1 - rho) / ((1 - rho) + 0.02),
/// by the true errors on the training scenes.
/// @param similarity  rho of ComparedProfiles, up to 1
double own_sigma_scale(double similarity);

/// Adds to the covariance of a line what both images get wrong alike: a shift across the line by 0.1 px
/// and a turn that moves each end by 0.03 px, as the left image shows them. Nothing for a line without
/// covariance.
void add_shared_error(const ProjectionMatrix& left_from_local, ReconstructedLine& line);

}  // namespace ridgeline::reconstruct
