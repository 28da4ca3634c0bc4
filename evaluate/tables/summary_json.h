// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/summary.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>

namespace ridgeline::evaluate {

/// Keeps keys in insertion order.
using Json = nlohmann::ordered_json;

/// A number, or null if it is missing or not finite: JSON has no NaN.
inline Json number_json(std::optional<double> value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json interval_json(const std::optional<Interval>& interval);  ///< [low, high] or null

/// Every figure of a summary except its class and groups, in full precision.
Json summary_json(const Summary& summary);

/// The same for a class, with `decided_by`: the figures of each of kDecidedGroups, by name.
Json class_json(const Summary& summary);

/// Indented text with a final line feed; bytes that are not UTF-8 become U+FFFD.
std::string dump(const Json& json);

}  // namespace ridgeline::evaluate
