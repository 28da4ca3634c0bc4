// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/files/yaml_check.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::io {

/// Whether the key `images` of a patch gives a folder, a pattern or a list of these, rather than
/// individual images.
bool names_files(const YamlMap& patch);

/// The files given by the key `images`, sorted by name within each folder and pattern; from a
/// folder, those with an image extension. Relative paths are relative to `folder`. Throws IoError
/// for a folder without images and a pattern without a match.
std::vector<std::string> image_files(const YamlMap& patch, const std::filesystem::path& folder);

}  // namespace ridgeline::io
