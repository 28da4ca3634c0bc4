// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/ok2011/artificial_point.h"
#include "reconstruct/estimate/ok2011/point_weight.h"
#include "reconstruct/estimate/tracked_lines.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// An artificial point and the values by which it is selected.
struct CandidatePoint {
  EstimatedPoint estimated;
  RankedPoint ranked;
};

/// Whether a point of the conditioned frame lies in front of all cameras that show a line and
/// within the height range.
bool plausible(const TrackedLines& lines, const ObservedTrack& line, const Eigen::Vector4d& x);

/// Weight W of Eq. 6 for a line and a neighbour: how well they meet in the images that show both, 0
/// to 1; 0 for fewer than two such images.
double pair_weight(const TrackedLines& lines, const ObservedTrack& line, int neighbour);

/// Where a view shows the artificial point of a line: where the line crosses the neighbour, or the
/// image of the point in a view without the neighbour.
Eigen::Vector2d crossing_in_view(const TrackedLines& lines,
                                 const ObservedLine& seen,
                                 const CandidatePoint& point);

/// The artificial points of a line, one per neighbour that at least two images show together with
/// it: the point in object space of their intersections in all of these images (Ok et al. 2011,
/// section 3.1). Points are left out if their weight is zero or if they are undetermined, behind a
/// camera or outside the height range.
std::vector<CandidatePoint> candidate_points(const TrackedLines& lines,
                                             const ObservedTrack& line,
                                             std::span<const int> neighbours);

}  // namespace ridgeline::reconstruct
