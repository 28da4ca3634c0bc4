// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/surface_oracle.h"

#include <cstddef>
#include <vector>

namespace ridgeline::simulate {

/// Minimum length of the visible part of a true edge in each image.
inline constexpr double kMinShownLength_px = 10.0;

/// The image of a part of an edge.
Segment2 image_of(const SurfaceOracle& oracle,
                  std::size_t view,
                  const Segment3& edge,
                  const PlanInterval& part);

/// The runs of an edge, as parameters of its segment, that are visible in one view: nothing
/// occludes them and the surfaces on the two sides differ.
std::vector<PlanInterval> visible_runs(const SurfaceOracle& oracle,
                                       std::size_t view,
                                       const Segment3& edge);

/// The share of an edge covered by its runs.
double total_length(const std::vector<PlanInterval>& runs);

/// The visible share of each true line's length, by line, in order of SyntheticScene::lines, and
/// view.
std::vector<std::vector<double>> visible_shares(const SyntheticScene& scene,
                                                const SurfaceOracle& oracle);

}  // namespace ridgeline::simulate
