// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/common/as_flags.h"
#include "io/project/patch.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ridgeline::apps {

/// Prints the main output of a command (`info`, `gate`, `compare`), with option names of the
/// libraries replaced by flags.
inline void answer(std::string_view text) { fmt::print("{}", as_flags(text)); }

/// Like answer(), but for the summary of what a command wrote; prints nothing with --quiet.
template <typename... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
  if (spdlog::get_level() < spdlog::level::err)
    answer(fmt::format(format, std::forward<Values>(values)...));
}

/// Prints decisions to stderr.
inline void inform_of(const std::vector<std::string>& decisions) {
  for (const std::string& decision : decisions) spdlog::info("{}", decision);
}

/// Prints warnings to stderr.
inline void warn_of(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) spdlog::warn("{}", warning);
}

/// Prints the decisions and warnings of a patch.
inline void tell_of(const io::Patch& patch) {
  inform_of(patch.decisions);
  warn_of(patch.warnings);
}

}  // namespace ridgeline::apps
