// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/surface_oracle.h"

#include <cstddef>
#include <vector>

namespace ridgeline::simulate {

/// Least length of the visible part of an edge of the truth in each image.
inline constexpr double kMinShownLength_px = 10.0;

/// Image of a part of an edge.
Segment2 image_of(const SurfaceOracle& oracle,
                  std::size_t view,
                  const Segment3& edge,
                  const PlanInterval& part);

/// Runs of an edge, as parameters of its segment, where one view sees it: nothing lies before it
/// and the surfaces on its two sides are not the same.
std::vector<PlanInterval> visible_runs(const SurfaceOracle& oracle,
                                       std::size_t view,
                                       const Segment3& edge);

/// The share of an edge that its runs are.
double total_length(const std::vector<PlanInterval>& runs);

/// How much of each true line each view sees: shares of its length by line, in order of
/// SyntheticScene::lines, and view.
std::vector<std::vector<double>> visible_shares(const SyntheticScene& scene,
                                                const SurfaceOracle& oracle);

}  // namespace ridgeline::simulate
