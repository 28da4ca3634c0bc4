// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>

namespace ridgeline {

inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;

}  // namespace ridgeline
