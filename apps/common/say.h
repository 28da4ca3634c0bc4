// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <string>
#include <utility>
#include <vector>

namespace ridgeline::apps {

/// Prints a summary of what a command wrote to stdout; nothing with --quiet. Answers that a command
/// is called for
/// (`info`, `gate`, `compare`) are printed whatever is set.
template <typename... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
  if (spdlog::get_level() < spdlog::level::err) fmt::print(format, std::forward<Values>(values)...);
}

/// Prints what was decided to stderr.
inline void inform_of(const std::vector<std::string>& decisions) {
  for (const std::string& decision : decisions) spdlog::info("{}", decision);
}

/// Prints warnings to stderr.
inline void warn_of(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) spdlog::warn("{}", warning);
}

}  // namespace ridgeline::apps
