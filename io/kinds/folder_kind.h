// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/kinds/file_kind.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Identifies a folder by the names of its entries: results of ridgeline, patches, a block, LIMAP
/// tracks, a COLMAP model, orientations_in(); otherwise the number of clouds, images and line
/// files.
FileKind kind_of_folder(const std::filesystem::path& folder);

/// The patch.yaml of a folder, or those of its subfolders, sorted.
std::vector<std::string> patch_files_in(const std::filesystem::path& folder);

/// The path of the block file of a folder, whether it exists or not.
std::string block_file_in(const std::filesystem::path& folder);

/// The orientations in a folder, recognised by their content; without any, those in its subfolders
/// and their subfolders with names that OpenSfM, OpenDroneMap, Pix4D and COLMAP give. Sorted.
std::vector<std::string> orientations_in(const std::filesystem::path& folder);

}  // namespace ridgeline::io
