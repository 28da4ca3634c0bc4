// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/pipeline/parameters.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace ridgeline::python {

// Names in messages for data in memory, which have no path.
inline constexpr const char* kCloudInMemory = "cloud";
inline constexpr const char* kGatesInMemory = "gates";
inline constexpr const char* kLinesInMemory = "lines";
inline constexpr const char* kReferencesInMemory = "reference_lines";
inline constexpr const char* kViewsInMemory = "views";

/// Whether a path is one of these names. Errors in such data are the caller's, not those of a file.
inline bool is_in_memory(std::string_view path) {
  constexpr std::array<std::string_view, 6> kNames{kCloudInMemory, kGatesInMemory,
                                                   kLinesInMemory, kReferencesInMemory,
                                                   kViewsInMemory, apps::kConfigInMemory};
  return std::ranges::find(kNames, path) != kNames.end();
}

}  // namespace ridgeline::python
