// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>

namespace ridgeline {

inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;

inline double deg_from_rad(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }

}  // namespace ridgeline
