// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judged_planes.h"
#include "evaluate/line_evaluation.h"

#include <map>
#include <string>

namespace ridgeline::evaluate {

using PlanesById = std::map<std::uint64_t, const JudgedPlane*>;

/// What a judged line is of its roof, by its planes; "" where it was not judged.
///   ridge, hip   level, inclined edge that two planes fall away from
///   valley       edge that two planes rise from
///   eave, verge  border of an inclined plane across, along its slope (to 45 degrees in plan)
///   step         border of a level plane
std::string roof_kind(const LineEvaluation& line,
                      const Segment3& segment_in_local,
                      const PlanesById& planes);

}  // namespace ridgeline::evaluate
