// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/summary_json.h"

#include <string>

namespace ridgeline::evaluate {

/// The part of `evaluation.METHOD.json` that describes an area, except the line numbers, which are
/// stored with the lines. For a decoy it contains the line that was moved, how it was moved, and
/// the result.
Json area_json(const AreaPart& area);
/// Reads the output of area_json(). Throws std::invalid_argument for anything else.
AreaPart parse_area(const Json& json);

/// JudgingPlane::points as text: the number of points, then line, plane and number of shared
/// points.
std::string points_text(const PlanePoints& points);
/// The inverse. Throws std::invalid_argument for other text.
PlanePoints parse_points(const std::string& text);

}  // namespace ridgeline::evaluate
