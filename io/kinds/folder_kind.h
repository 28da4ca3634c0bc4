// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/file_kind.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::io {

/// What a folder is by the names of what lies in it: results of the program, patches, LIMAP's
/// tracks, a model of COLMAP, else how many clouds, images and line files. Nothing is opened.
FileKind kind_of_folder(const std::filesystem::path& folder);

/// The patch.yaml of a folder, or those of its subfolders, sorted.
std::vector<std::string> patch_files_in(const std::filesystem::path& folder);

}  // namespace ridgeline::io
