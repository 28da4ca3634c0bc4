// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace ridgeline::io {

/// Whether objects and arrays are nested at most 64 deep. Copying and serialising JSON is
/// recursive, so the depth of a file is checked before it is parsed.
bool is_shallow_json(std::string_view text);

/// The first characters of a value as JSON, for a message; bytes that are not UTF-8 are replaced.
std::string excerpt(const nlohmann::json& value);

/// A value as JSON text; bytes that are not UTF-8 are replaced.
std::string json_text(const nlohmann::json& value);

}  // namespace ridgeline::io
