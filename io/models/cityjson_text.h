// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <string_view>

namespace ridgeline::io {

/// Whether a text is a sequence (CityJSONSeq): its first line is a document of its own, which
/// others follow.
bool is_cityjson_sequence(std::string_view text);

/// Calls `take` with the document of a text, then, of a sequence, with each feature, and with the
/// place for messages ("PATH: line 7"). Throws IoError for text that is no JSON, is nested too
/// deeply, or whose "type" is not CityJSON, of features CityJSONFeature.
void for_each_cityjson(const std::string& path,
                       std::string_view text,
                       const std::function<void(nlohmann::json, const std::string&)>& take);

}  // namespace ridgeline::io
