// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/constant_shift.h"
#include "evaluate/tables/summary_json.h"

#include <optional>

namespace ridgeline::evaluate {

/// The shift as `evaluation.METHOD.json` holds it; null if there is none. An axis that the planes
/// do not tell is null.
Json shift_json(const std::optional<ConstantShift>& shift);

/// Reads what shift_json() wrote. Throws std::invalid_argument "what: value; rule" for anything
/// else.
std::optional<ConstantShift> parse_shift(const Json& json);

}  // namespace ridgeline::evaluate
