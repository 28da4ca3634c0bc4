// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace ridgeline::io {

/// Whether objects and arrays lie within each other at most 64 deep. Copies and texts of JSON are
/// recursive, so the depth of a file is bounded before it is parsed.
bool is_shallow_json(std::string_view text);

/// The first characters of a value as JSON, for a message; bytes that are no UTF-8 are replaced.
std::string excerpt(const nlohmann::json& value);

/// A value as JSON text; bytes that are no UTF-8 are replaced.
std::string json_text(const nlohmann::json& value);

}  // namespace ridgeline::io
