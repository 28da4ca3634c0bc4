// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/field.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace ridgeline::apps {

/// "corridor_half_width_m" -> "--corridor-half-width-m".
inline std::string flag_of(std::string_view field_name) {
  std::string flag = "--" + std::string(field_name);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

/// One flag per field of an options struct, with its help and default; ranges are checked by
/// validate() where the options are used, so that every caller gets the same message. A command
/// with several such structs tells them apart by a prefix: "extract_" gives --extract-....
template <typename Options>
void add_flags(CLI::App& app,
               Options& options,
               const std::string& group,
               const std::string& prefix = "") {
  for_each_field<Options>([&](const auto& field) {
    app.add_option(flag_of(prefix + std::string(field.name)), options.*field.member,
                   std::string(field.help))
        ->capture_default_str()
        ->group(group);
  });
}

/// The options as used, for run.json.
template <typename Options>
nlohmann::ordered_json echo(const Options& options) {
  nlohmann::ordered_json json;
  for_each_field<Options>(
      [&](const auto& field) { json[std::string(field.name)] = options.*field.member; });
  return json;
}

}  // namespace ridgeline::apps
