// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/recognise.h"

#include <optional>
#include <string>

namespace ridgeline::io {

/// Throws IoError if `path` does not exist or is no regular file: a device may never end, and a
/// named pipe without a writer is never opened. If `expected` is given, the message for a folder
/// tells its kind.
void require_regular_file(const std::string& path, std::optional<Expected> expected = std::nullopt);

/// All bytes of a regular file, or of a pipe that the program was started with (/dev/stdin,
/// Throws IoError if the path names anything else or cannot be read. If the beginning is known to
/// be of another kind than `expected`, it throws before more is read. is known to be of another
/// kind than `expected`.
std::string read_input(const std::string& path, std::optional<Expected> expected = std::nullopt);

}  // namespace ridgeline::io
