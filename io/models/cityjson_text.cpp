// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/cityjson_text.h"

#include "io/error.h"
#include "io/text/json_text.h"
#include "io/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ridgeline::io {
namespace {

using nlohmann::json;

json parsed(const std::string& where, std::string_view text) {
  if (!is_shallow_json(text))
    throw IoError(where, "is not CityJSON: its arrays and objects are nested too deeply");
  try {
    return json::parse(text);
  } catch (const json::exception& error) {
    const std::string message = error.what();
    throw IoError(where, "is not CityJSON: " + message.substr(message.find("] ") + 2));
  }
}

json of_type(const char* type, const std::string& where, std::string_view text) {
  json document = parsed(where, text);
  if (!document.is_object() || document.value("type", json()) != type)
    throw IoError(where, fmt::format("is not CityJSON: \"type\" must be \"{}\"", type));
  return document;
}

}  // namespace

bool is_cityjson_sequence(std::string_view text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return false;
  const std::string_view first = trimmed(text.substr(0, end));
  return first.starts_with('{') && first.ends_with('}') &&
         text.find_first_not_of(" \t\r\n", end) != std::string_view::npos;
}

void for_each_cityjson(const std::string& path,
                       std::string_view text,
                       const std::function<void(json, const std::string&)>& take) {
  if (!is_cityjson_sequence(text)) return take(of_type("CityJSON", path, text), path);
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view row = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (row.empty()) continue;
    const std::string where = fmt::format("{}: line {}", path, line);
    take(of_type(line == 1 ? "CityJSON" : "CityJSONFeature", where, row), where);
  }
}

}  // namespace ridgeline::io
