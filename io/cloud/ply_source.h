// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/files/mapped_file.h"

#include <memory>
#include <string>

namespace ridgeline::io {

/// Opens the element `vertex` of a mapped PLY file (ascii, binary of either byte order). Numbers of
/// any type are read as doubles; elements before `vertex` are skipped. `path` is used only in
/// messages. Throws IoError.
std::unique_ptr<CloudSource> open_ply(MappedFile file, const std::string& path);

}  // namespace ridgeline::io
