// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace ridgeline::results {

/// What to call the patch of a cloud that no patch file names: one file by its name without
/// extension; several files, or a pattern, by the deepest folder that holds them all, without the
/// folders that a pattern leaves open: `tiles/*.laz` is tiles, `*/x.laz` the current folder, and
/// `cloud` where only the root of the file system holds all.
std::string cloud_name(const std::vector<std::string>& paths_or_patterns);

}  // namespace ridgeline::results
