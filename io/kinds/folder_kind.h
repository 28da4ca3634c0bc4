// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/file_kind.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Identifies a folder by the names of its entries: results of ridgeline, patches, LIMAP tracks, a
/// COLMAP model; otherwise the number of clouds, images and line files. No file is opened.
FileKind kind_of_folder(const std::filesystem::path& folder);

/// The patch.yaml of a folder, or those of its subfolders, sorted.
std::vector<std::string> patch_files_in(const std::filesystem::path& folder);

}  // namespace ridgeline::io
