// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/conditioned_view.h"

namespace ridgeline::reconstruct {

/// How likely two matched lines meet in object space, judged by their images alone, without their
/// heights.
struct Junction {
  double prior = 0.5;    ///< probability that they meet
  double sigma_m = 0.0;  ///< sigma of their distance if they meet
};

/// The junction of two lines by the place of their crossing: at the ends of the segments, within
/// them or beyond them (mean of the images that show both, of which there must be one). Two ends in
/// one place are a corner (0.87). An end on a line is an edge that stops or is hidden there (0.7).
/// Two lines that cross are mostly at two heights (0.35). Lines that would meet beyond their ends
/// meet if they lie in one plane (0.45). The last kind misses by sigma_meeting_m, the others by
/// half of it.
///
/// These are frequencies and scatter of the simulated villages of seeds 1 to 8 and 21 to 28, among
/// not_aligned lines with a height sigma below 0.12 m. Misses below 0.25 m count as meetings, less
/// the chance ones that the frequency of larger misses predicts (68 % of them below 0.05 m, beyond
/// the ends below 0.1 m).
Junction junction(const ConditionedViews& frames,
                  const ObservedTrack& a,
                  const ObservedTrack& b,
                  double sigma_meeting_m);

}  // namespace ridgeline::reconstruct
