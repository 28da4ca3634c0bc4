// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/ok2011/estimate/artificial_point.h"
#include "reconstruct/ok2011/estimate/options.h"
#include "reconstruct/ok2011/estimate/point_weight.h"
#include "reconstruct/views/stereo_lines.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// An artificial point and the figures by which it is selected.
struct CandidatePoint {
  EstimatedPoint estimated;
  RankedPoint ranked;
};

/// Whether a point of the conditioned frame lies in front of both cameras and within the heights.
bool plausible(const StereoLines& lines, const Eigen::Vector4d& x);

/// Weight W of Eq. 6 of a line and a neighbour: how well they meet in both images, 0 to 1.
double pair_weight(const StereoLines& lines,
                   const ObservedPair& line,
                   int neighbour,
                   const ReconstructOptions& options);

/// The artificial points of a line: its intersections with each of the neighbours in both images
/// and their points in object space (Ok et al. 2011, section 3.1). Points are left out if their weight is
/// zero, if they are undetermined, behind a camera or outside the range of heights.
std::vector<CandidatePoint> candidate_points(const StereoLines& lines,
                                             const ObservedPair& line,
                                             std::span<const int> neighbours,
                                             const ReconstructOptions& options);

}  // namespace ridgeline::reconstruct
