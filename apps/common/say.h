// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/core.h>
#include <spdlog/spdlog.h>

#include <utility>

namespace ridgeline::apps {

/// Prints a summary of what a command wrote to stdout; nothing with --quiet. Answers that a command is called for
/// (`info`, `gate`, `compare`) are printed whatever is set.
template <typename... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
  if (spdlog::get_level() < spdlog::level::err) fmt::print(format, std::forward<Values>(values)...);
}

}  // namespace ridgeline::apps
