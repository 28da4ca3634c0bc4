// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_support.h"

#include <optional>
#include <span>

namespace ridgeline::evaluate {

/// The top of a parapet or a wall: a strip along the line, too narrow for its tilt across to be
/// seen, hence taken as level across. Only points that no candidate explains, above all of them by
/// 0.2 m to 1.5 m, count. Found by sample consensus on the straight line of their heights along s.
std::optional<CandidatePlane> search_ledge(std::span<const ZonePoint> zone,
                                           std::span<const CandidatePlane> candidates,
                                           const Footprint& footprint,
                                           const JudgeOptions& options);

}  // namespace ridgeline::evaluate
