// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/common/as_flags.h"
#include "reconstruct/geometry/field.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>
#include <type_traits>

namespace ridgeline::apps {

/// Accepts numbers in [lowest, highest], but not NaN. The validator has no description, because
/// CLI11 would print it in the help of every option.
template <typename T>
CLI::Validator in_range(T lowest, T highest) {
  return CLI::Validator(
      [lowest, highest](const std::string& text) {
        T value{};
        if (!CLI::detail::lexical_cast(text, value)) return "'" + text + "' is not a number";
        if (value >= lowest && value <= highest) return std::string();
        return fmt::format("{}, must be in [{:g}, {:g}]", text, static_cast<double>(lowest),
                           static_cast<double>(highest));
      },
      "");
}

/// Adds one flag per field of an options struct, with its help, default and range. `prefix`
/// distinguishes several such structs in one command: "extract_" gives --extract-....
template <typename Options>
void add_flags(CLI::App& app,
               Options& options,
               const std::string& group,
               const std::string& prefix = "") {
  for_each_field<Options>([&](const auto& field) {
    CLI::Option* option = app.add_option(flag_of(prefix + std::string(field.name)),
                                         options.*field.member, std::string(field.help));
    option->capture_default_str()->group(group);
    if constexpr (!std::is_same_v<decltype(field.lowest), const bool>) {
      option->check(in_range(field.lowest, field.highest));
    }
  });
}

}  // namespace ridgeline::apps
