// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/surface_oracle.h"

#include <cstddef>
#include <vector>

namespace ridgeline::simulate {

/// Which edges the truth of the images holds.
struct VisibilityOptions {
  double step_m = 0.1;           ///< distance of the lines of sight along an edge
  double longest_gap_m = 0.5;    ///< shorter interruptions are closed
  double shortest_px = 10.0;     ///< least length of the visible part in each image
  double flank_px = 1.0;         ///< distance from an edge at which its sides are looked at
  double least_contrast = 0.03;  ///< mean difference of the sides, share of the image's range
};

/// Image of a part of an edge.
Segment2 image_of(const SurfaceOracle& oracle,
                  std::size_t view,
                  const Segment3& edge,
                  const PlanInterval& part);

/// Runs of an edge, as parameters of its segment, where one view sees it: nothing lies before it
/// and the surfaces on its two sides are not the same.
std::vector<PlanInterval> visible_runs(const SurfaceOracle& oracle,
                                       std::size_t view,
                                       const Segment3& edge,
                                       const VisibilityOptions& options);

/// The share of an edge that its runs are.
double total_length(const std::vector<PlanInterval>& runs);

/// How much of each true line each view sees: shares of its length by line, in order of
/// Scene::lines, and view.
std::vector<std::vector<double>> visible_shares(const Scene& scene,
                                                const SurfaceOracle& oracle,
                                                const VisibilityOptions& options = {});

}  // namespace ridgeline::simulate
