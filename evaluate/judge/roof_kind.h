// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judged_planes.h"
#include "evaluate/line_evaluation.h"

#include <map>
#include <string>

namespace ridgeline::evaluate {

using PlanesById = std::map<std::uint64_t, const JudgedPlane*>;

/// The kind of roof edge that a judged line is, according to its planes; "" if it was not judged.
///   ridge   level edge from which two planes fall away
///   hip     inclined edge from which two planes fall away
///   valley  edge from which two planes rise
///   eave    border of an inclined plane across its slope (more than 45 degrees from it in plan)
///   verge   border of an inclined plane along its slope (up to 45 degrees from it in plan)
///   step    border of a level plane
std::string roof_kind(const LineEvaluation& line,
                      const Segment3& segment_in_local,
                      const PlanesById& planes);

}  // namespace ridgeline::evaluate
