// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/pipeline/parameters.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace ridgeline::python {

// Names that messages give to data in memory in place of a path.
inline constexpr const char* kCloudInMemory = "cloud";
inline constexpr const char* kGatesInMemory = "gates";
inline constexpr const char* kLinesInMemory = "lines";
inline constexpr const char* kReferencesInMemory = "reference_lines";
inline constexpr const char* kViewsInMemory = "views";

/// Whether a path is one of these names. A fault of such data is the caller's, not a file's.
inline bool is_in_memory(std::string_view path) {
  constexpr std::array<std::string_view, 6> kNames{kCloudInMemory, kGatesInMemory,
                                                   kLinesInMemory, kReferencesInMemory,
                                                   kViewsInMemory, apps::kConfigInMemory};
  return std::ranges::find(kNames, path) != kNames.end();
}

}  // namespace ridgeline::python
