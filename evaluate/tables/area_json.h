// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/summary_json.h"

#include <string>

namespace ridgeline::evaluate {

/// What `evaluation.METHOD.json` holds of an area, but for the numbers of the lines, which stand
/// with the lines. Of a decoy it has the line that was moved, the way and what came out.
Json area_json(const AreaPart& area);
/// Reads what area_json() wrote. Throws std::invalid_argument for anything else.
AreaPart parse_area(const Json& json);

/// JudgingPlane::points as text: their number, then line, plane and number of those that are
/// shared.
std::string points_text(const PlanePoints& points);
/// The inverse. Throws std::invalid_argument for other text.
PlanePoints parse_points(const std::string& text);

}  // namespace ridgeline::evaluate
