// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/recognise.h"

#include <optional>
#include <string>

namespace ridgeline::io {

/// Throws IoError if `path` does not exist or is no regular file: a device may never end, and a
/// named pipe without a writer is never opened. If `expected` is given, the message for a folder
/// tells its kind.
void require_regular_file(const std::string& path,
                          std::optional<FileGroup> expected = std::nullopt);

/// All bytes of a regular file, or of a pipe that the program was started with (/dev/stdin, at most
/// 64 MiB), without the byte order mark of UTF-8. Throws IoError if the path names anything else or
/// cannot be read, and if the beginning is known to be of another kind than `expected`, before more
/// is read.
std::string read_input(const std::string& path, std::optional<FileGroup> expected = std::nullopt);

}  // namespace ridgeline::io
