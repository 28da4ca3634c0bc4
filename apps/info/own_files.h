// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/file_kind.h"

#include <string>

namespace ridgeline::apps {

/// Whether print_own_file() supports the kind: gates, config, tables of matches and segments,
/// results.
bool is_own_file(io::FileGroup group);

/// Prints the content of a file or folder of the program and the command that uses it. Throws
/// IoError if that command would reject it.
void print_own_file(const std::string& path, const io::FileKind& kind);

/// Prints "  use         WHAT".
void print_use(const std::string& what);

}  // namespace ridgeline::apps
