// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/files/yaml_check.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Whether the key `images` of a patch names files, by a folder, a pattern or a list of them, and
/// not images one by one.
bool names_files(const YamlMap& patch);

/// These files, sorted by name within each folder and pattern; of a folder the files with an
/// extension of images. Relative paths are relative to `folder`. Throws IoError for a folder
/// without images and a pattern without a match.
std::vector<std::string> image_files(const YamlMap& patch, const std::filesystem::path& folder);

}  // namespace ridgeline::io
