// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_support.h"

#include <optional>
#include <span>

namespace ridgeline::evaluate {

/// The top of a parapet or a wall: a strip along the line that is too narrow for its tilt across
/// the line to be determined, and is therefore assumed to be level in that direction. Only points
/// that lie 0.2 m to 1.5 m above all candidates are considered. The strip is found by sample
/// consensus of a straight line through their heights along s. Empty if there is no such strip.
std::optional<CandidatePlane> search_ledge(std::span<const ZonePoint> zone,
                                           std::span<const CandidatePlane> candidates,
                                           const Footprint& footprint,
                                           const JudgeOptions& options);

}  // namespace ridgeline::evaluate
