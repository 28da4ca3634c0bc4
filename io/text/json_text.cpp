// SPDX-License-Identifier: BSD-3-Clause
#include "io/text/json_text.h"

namespace ridgeline::io {

bool is_shallow_json(std::string_view text) {
  constexpr int kMaxDepth = 64;
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string && c == '\\') ++i;  // the character after a backslash does not end the string
    if (c == '"') in_string = !in_string;
    if (in_string) continue;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth > kMaxDepth) return false;
  }
  return true;
}

std::string excerpt(const nlohmann::json& value) {
  constexpr std::size_t kShown = 60;
  return json_text(value).substr(0, kShown);
}

std::string json_text(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace ridgeline::io
