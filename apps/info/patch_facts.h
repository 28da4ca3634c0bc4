// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/info/info_warnings.h"
#include "io/kinds/file_kind.h"

#include <string>

namespace ridgeline::apps {

/// Prints the content of a patch file. Throws IoError like read_patch().
void print_patch(const std::string& path, InfoWarnings& warnings);

/// Prints the patch of a folder, or a list of the patches of its subfolders. Throws IoError like
/// read_patch().
void print_patches(const std::string& folder, const io::FileKind& kind, InfoWarnings& warnings);

}  // namespace ridgeline::apps
