// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace ridgeline::results {

/// The default name of a patch that is judged without a patch file. For a single cloud file it is
/// the file name without its extension. For several files or a pattern it is the name of the
/// deepest folder that contains them all, ignoring folders matched by a wildcard: `tiles` for
/// `tiles/*.laz`, the current folder for `*/x.laz`. It is `cloud` if only the root of the file
/// system contains them all.
std::string cloud_name(const std::vector<std::string>& paths_or_patterns);

}  // namespace ridgeline::results
