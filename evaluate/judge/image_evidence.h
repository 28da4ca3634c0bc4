// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/point_search.h"
#include "evaluate/line_evaluation.h"
#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"

#include <optional>
#include <vector>

namespace ridgeline::evaluate {

/// The base segment on the LIDAR surface (monoplotting). The rays through samples of the segment
/// end at the first point of the cloud that they come close to, which is within a radius in plan
/// that holds two to three points. A line is fitted robustly to the heights so found. Nothing if
/// most rays meet no point, if no straight line explains them, or if the result has no direction in
/// plan.
std::optional<Segment3> monoplot(const PointSearch& search, const ImageEvidence& images);

/// Whether an image after the first two says something that they do not: its projection centre lies
/// 10 degrees off the base of these two, seen from the first.
bool has_independent_observation(const ImageEvidence& images);

/// How far the observations are from where a plane carries the base observation, across them, in
/// units of sigma_px squared: mean of both ends, sum over the other images. A single observation
/// counts 25 at most, as it may be of another edge.
double observations_chi_square(const ImageEvidence& images, const Plane3& plane, double sigma_px);

/// The same of the line that the first two observations triangulate to, over the images after
/// these.
double observations_chi_square(const ImageEvidence& images, double sigma_px);

/// Plan views of the base segment at heights from the lowest to the highest: the points that
/// monoplot() may need lie within `spacing_m` of them.
std::vector<Segment2> plan_sweep(const ImageEvidence& images, double spacing_m);

}  // namespace ridgeline::evaluate
