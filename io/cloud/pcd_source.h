// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/files/mapped_file.h"

#include <memory>
#include <string>

namespace ridgeline::io {

/// Opens a mapped PCD file (0.6, 0.7; ascii, binary, binary_compressed). Numbers of any type are
/// read as doubles. `path` is used only in messages. As in PCL, the viewpoint is not applied.
/// Throws IoError naming the line or field. Source: pointclouds.org, "The PCD file format".
std::unique_ptr<CloudSource> open_pcd(MappedFile file, const std::string& path);

}  // namespace ridgeline::io
