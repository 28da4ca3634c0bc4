// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ridgeline::io {

/// The content of a file. Throws IoError if it cannot be read.
std::string read_text_file(const std::string& path);

}  // namespace ridgeline::io
