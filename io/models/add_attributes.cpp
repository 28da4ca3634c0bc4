// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/add_attributes.h"

#include "io/models/cityjson_text.h"

#include <nlohmann/json.hpp>

#include <set>
#include <utility>
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

/// Returns false if an object that has values is already in `done`.
bool add_to(json& document,
            const std::vector<Column>& columns,
            const BuildingValues& values,
            std::set<std::string>& done) {
  const auto objects = document.find("CityObjects");
  if (objects == document.end() || !objects->is_object()) return true;
  for (auto& [id, object] : objects->items()) {
    const auto found = values.find(id);
    if (found == values.end() || !object.is_object()) continue;
    if (!done.insert(id).second) return false;
    json& attributes = object["attributes"];
    if (!attributes.is_object()) attributes = json::object();
    for (const Column& column : columns) attributes.erase(column.name);
    for (const auto& [column, value] : found->second)
      attributes[columns[column].name] = json_of(value);
  }
  return true;
}

}  // namespace

std::optional<std::string> with_attributes(const std::string& path,
                                           std::string_view content,
                                           const std::vector<Column>& columns,
                                           const BuildingValues& values) {
  const bool in_lines = is_cityjson_sequence(content);
  std::string text;
  std::set<std::string> done;
  bool are_told_apart = true;
  for_each_cityjson(path, content, [&](json document, const std::string&) {
    are_told_apart = add_to(document, columns, values, done) && are_told_apart;
    text += document.dump(-1, ' ', false, json::error_handler_t::replace);
    if (in_lines) text += "\n";
  });
  return are_told_apart ? std::optional(std::move(text)) : std::nullopt;
}

}  // namespace ridgeline::io
