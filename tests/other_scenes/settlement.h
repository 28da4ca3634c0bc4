// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/scene_model.h"

#include <cstdint>

namespace ridgeline::other {

/// A settlement of houses with gardens along streets; every second seed has streets within 4
/// degrees of the x or the y axis, near the direction of the base of the cameras (cameras_for()).
/// The same scene for the same seed on every platform. `is_hard`: on ground that falls by 3 to 8 %,
/// most houses with an annex, small dormers or both.
Scene make_settlement(std::uint64_t seed, bool is_hard = false);

}  // namespace ridgeline::other
