// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/point_search.h"
#include "evaluate/line_evaluation.h"
#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"

#include <optional>
#include <vector>

namespace ridgeline::evaluate {

/// The base segment projected onto the LIDAR surface (monoplotting). The rays through samples of
/// the segment end at the first point of the cloud that lies close to them, within a radius in plan
/// that holds two to three points. A line is fitted robustly to the resulting heights. Empty if
/// most rays meet no point, if no straight line explains the heights, or if the result has no
/// direction in plan.
std::optional<Segment3> monoplot(const PointSearch& search, const ImageEvidence& images);

/// Whether an image after the first two provides information that they do not: seen from the first
/// projection centre, its own lies at least 10 degrees off the base of these two.
bool has_independent_observation(const ImageEvidence& images);

/// Squared distances of the base observation, transferred via the plane into the other images, from
/// the straight lines observed there, over sigma_px^2: mean of both ends, sum over the other
/// images. Each observation contributes at most 25, because it may belong to another edge.
double observations_chi_square(const ImageEvidence& images, const Plane3& plane, double sigma_px);

/// The same for the line triangulated from the first two observations, summed over the images after
/// these.
double observations_chi_square(const ImageEvidence& images, double sigma_px);

/// Plan views of the base segment at heights from the lowest to the highest: the points that
/// monoplot() may need lie within `spacing_m` of them.
std::vector<Segment2> plan_sweep(const ImageEvidence& images, double spacing_m);

}  // namespace ridgeline::evaluate
