// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/recognise.h"

#include <optional>
#include <string>

namespace ridgeline::io {

/// Throws IoError if `path` does not exist or is not a regular file: a device may never end, and
/// opening a named pipe without a writer would block. If `expected` is given, the message for a
/// folder states its kind.
void require_regular_file(const std::string& path,
                          std::optional<FileGroup> expected = std::nullopt);

/// All bytes of a regular file, or of a pipe that the program was started with (/dev/stdin, at most
/// 64 MiB), without a UTF-8 byte order mark. Throws IoError if the path is anything else or cannot
/// be read, and, before reading further, if the beginning is recognised as a kind other than
/// `expected`.
std::string read_input(const std::string& path, std::optional<FileGroup> expected = std::nullopt);

}  // namespace ridgeline::io
