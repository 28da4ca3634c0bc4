// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"
#include "evaluate/tables/summary_json.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// What `evaluation.METHOD.json` holds of an area, but for the numbers of the lines, which stand
/// with the lines. Of a decoy it has the line that was moved, the way and what came out.
Json area_json(const AreaPart& area);
/// Reads what area_json() wrote. Throws std::invalid_argument for anything else.
AreaPart parse_area(const Json& json);

// JudgingPlane::sample as text, five letters a value.
std::string sample_text(const std::vector<std::uint32_t>& sample);
// The inverse. Throws std::invalid_argument for other text.
std::vector<std::uint32_t> parse_sample(const std::string& text);

}  // namespace ridgeline::evaluate
