// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace ridgeline::results {

/// What to call the patch of a cloud that no patch file names. A single file gives its name without
/// extension. Several files, or a pattern, give the name of the deepest folder that holds them all,
/// without the folders that a pattern leaves open: `tiles/*.laz` gives tiles, `*/x.laz` the current
/// folder. The name is `cloud` if only the root of the file system holds them all.
std::string cloud_name(const std::vector<std::string>& paths_or_patterns);

}  // namespace ridgeline::results
