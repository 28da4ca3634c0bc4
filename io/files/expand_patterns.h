// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace ridgeline::io {

/// Replaces patterns by the sorted names they match, and keeps plain paths.
/// Throws IoError naming a pattern that matches nothing.
std::vector<std::string> expand_patterns(const std::vector<std::string>& paths_or_patterns);

}  // namespace ridgeline::io
