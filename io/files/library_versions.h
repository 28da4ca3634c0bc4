// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ridgeline::io {

/// Names and versions of the libraries that read and write files.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace ridgeline::io
