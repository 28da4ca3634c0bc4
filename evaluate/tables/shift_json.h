// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/constant_shift.h"
#include "evaluate/tables/summary_json.h"

#include <optional>

namespace ridgeline::evaluate {

/// The shift in the format of `evaluation.METHOD.json`; null if there is none. An axis that the
/// planes do not determine is null.
Json shift_json(const std::optional<ConstantShift>& shift);

/// Reads the output of shift_json(). Throws std::invalid_argument "what: value; rule" for anything
/// else.
std::optional<ConstantShift> parse_shift(const Json& json);

}  // namespace ridgeline::evaluate
