// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/files/mapped_file.h"

#include <memory>
#include <string>

namespace ridgeline::io {

/// Opens the element `vertex` of a mapped PLY file (ascii, binary of either byte order). Numbers of
/// any type are kept as doubles; elements before it are skipped. `path` serves messages. Throws
/// IoError.
std::unique_ptr<CloudSource> open_ply(MappedFile file, const std::string& path);

}  // namespace ridgeline::io
