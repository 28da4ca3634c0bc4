// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/conditioned_view.h"
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "reconstruct/geometry/epipolar.h"

namespace ridgeline::reconstruct {

// The position of an edge has two errors. What both images show alike (the surfaces on both sides,
// light, sharpening) shifts the edge equally in both: the line moves across the rays and keeps its
// depth. What the images show differently shifts the edge in only one of them: the depth of the
// line is then wrong.

/// Factor for the sigmas across both edges of a match. Two edges between the same surfaces have
/// nearly the same error, so they agree far better than the accuracy of each suggests. If the
/// images show different surfaces, the edges agree far worse. Hence
///   scale^2 = 0.1 + 6 (1 - rho) / ((1 - rho) + 0.02),
/// fitted to the true errors on the training scenes.
/// @param similarity  rho of ComparedProfiles, up to 1
double own_sigma_scale(double similarity);

/// Factor for the sigmas across all observations of a line, from how well they agree. The
/// adjustment of the line to their N planes leaves the sum of squares Omega with 2 N - 4 degrees of
/// freedom. Together with the stated sigmas, which count as four degrees of freedom,
///   scale^2 = (4 + Omega) / 2 N,
/// the scale of the variance factor's posterior for a scaled inverse chi-square prior of scale 1
/// (Gelman et al. 2013, section 2.6). Four is fitted to the true errors on training scenes. 1 for
/// two observations, which always agree, and for coincident planes.
/// @param line  with the sigmas as stated so far
double agreement_sigma_scale(const ObservedTrack& line);

/// Adds the error common to both images to the covariance of a line: a shift across the line by 0.1
/// px and a turn that moves each end by 0.03 px, both measured in the left image. A line without
/// covariance is left unchanged.
void add_shared_error(const ProjectionMatrix& left_from_local, ReconstructedLine& line);

}  // namespace ridgeline::reconstruct
