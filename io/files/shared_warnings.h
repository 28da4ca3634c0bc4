// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace ridgeline::io {

/// Combines warnings "PATH: TEXT" that several files share: "PATH and 49 more files: TEXT" with the
/// first path. Warnings stay in the order of their first file.
std::vector<std::string> shared_warnings(const std::vector<std::string>& warnings);

}  // namespace ridgeline::io
