// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/recognise.h"

#include <optional>
#include <string>

namespace ridgeline::io {

/// Throws IoError if `path` does not exist or is no regular file: a device may never end, and a
/// named pipe without a writer is never opened. A folder is told by its kind where `expected` is known.
void require_regular_file(const std::string& path, std::optional<Expected> expected = std::nullopt);

/// All bytes of a regular file, or of a pipe that the program was started with (/dev/stdin,
/// /dev/fd/N), of which at most 64 MiB are taken.
/// Throws IoError if the path names anything else, or cannot be read, and, before more than its beginning is read, if that
/// is known to be of another kind than `expected`.
std::string read_input(const std::string& path, std::optional<Expected> expected = std::nullopt);

}  // namespace ridgeline::io
