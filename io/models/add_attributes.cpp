// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/add_attributes.h"

#include "io/models/cityjson_text.h"

#include <nlohmann/json.hpp>

#include <variant>

namespace ridgeline::io {
namespace {

using nlohmann::json;

json json_of(const Value& value) {
  if (const auto* const n = std::get_if<std::int64_t>(&value)) return *n;
  if (const auto* const x = std::get_if<double>(&value)) return *x;
  if (const auto* const text = std::get_if<std::string>(&value)) return *text;
  return nullptr;
}

void add_to(json& document, const std::vector<Column>& columns, const BuildingValues& values) {
  const auto objects = document.find("CityObjects");
  if (objects == document.end() || !objects->is_object()) return;
  for (auto& [id, object] : objects->items()) {
    const auto found = values.find(id);
    if (found == values.end() || !object.is_object()) continue;
    json& attributes = object["attributes"];
    if (!attributes.is_object()) attributes = json::object();
    for (const auto& [column, value] : found->second)
      attributes[columns[column].name] = json_of(value);
  }
}

}  // namespace

std::string with_attributes(const std::string& path,
                            std::string_view content,
                            const std::vector<Column>& columns,
                            const BuildingValues& values) {
  const bool in_lines = is_cityjson_sequence(content);
  std::string text;
  for_each_cityjson(path, content, [&](json document, const std::string&) {
    add_to(document, columns, values);
    text += document.dump(-1, ' ', false, json::error_handler_t::replace);
    if (in_lines) text += "\n";
  });
  return text;
}

}  // namespace ridgeline::io
