// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/plan_polygon.h"

#include <Eigen/Core>

#include <span>

namespace ridgeline::evaluate {

/// The share of a polygon's area that lies within `radius_m` of one of the points; 0 without
/// points. It is sampled at positions half a radius apart, or farther apart if there would be more
/// than about 100,000 of them. Throws std::invalid_argument unless the radius is positive.
double covered_share(const PlanPolygon& polygon,
                     std::span<const Eigen::Vector2d> points,
                     double radius_m);

}  // namespace ridgeline::evaluate
