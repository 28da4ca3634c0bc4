// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// Whether a text is a sequence (CityJSONSeq): its first line is a complete document, which others
/// follow.
bool is_cityjson_sequence(std::string_view text);

/// Calls `take` with the document of a text, then, for a sequence, with each feature; the string is
/// the location for messages ("PATH: line 7"). Throws IoError for text that is not JSON, is nested
/// too deeply, or whose "type" is not CityJSON (for features: CityJSONFeature).
void for_each_cityjson(const std::string& path,
                       std::string_view text,
                       const std::function<void(nlohmann::json, const std::string&)>& take);

}  // namespace ridgeline::io
