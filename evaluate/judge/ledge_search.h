// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_support.h"

#include <optional>
#include <span>

namespace ridgeline::evaluate {

/// The top of a parapet or a wall: a strip along the line that is too narrow for its tilt across to
/// be seen, and is taken as level across. Only points that lie 0.2 m to 1.5 m above all candidates
/// count. The strip is found by sample consensus on the straight line of their heights along s.
/// Nothing if there is none.
std::optional<CandidatePlane> search_ledge(std::span<const ZonePoint> zone,
                                           std::span<const CandidatePlane> candidates,
                                           const Footprint& footprint,
                                           const JudgeOptions& options);

}  // namespace ridgeline::evaluate
