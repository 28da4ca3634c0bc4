// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/files/mapped_file.h"

#include <memory>
#include <string>

namespace ridgeline::io {

/// Whether the name has the extension of a text cloud: .xyz .txt .csv .asc .pts (any case).
bool has_xyz_name(const std::string& path);

/// Opens a mapped text file with one point per line, in the layout that find_text_layout() finds.
/// Throws IoError.
std::unique_ptr<CloudSource> open_xyz(MappedFile file, const std::string& path);

}  // namespace ridgeline::io
