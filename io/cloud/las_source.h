// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/files/mapped_file.h"

#include <memory>
#include <string>

namespace ridgeline::io {

/// Opens a mapped LAS file; `path` is used only in messages. Compressed files (LAZ, COPC),
/// identified by the compression bits of the point format, are passed on to open_laz().
/// Throws IoError under the same conditions as parse_las_header().
std::unique_ptr<CloudSource> open_las(MappedFile file,
                                      const std::string& path,
                                      const OpenCloudOptions& options);

}  // namespace ridgeline::io
