// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"
#include "io/cloud/las_header.h"
#include "io/files/mapped_file.h"

#include <memory>

namespace ridgeline::io {

/// Opens the points of a LAZ or COPC file whose header has been read; `file_info` holds the path
/// and the contents of the header. A damaged COPC hierarchy only causes a warning: the points are
/// read without it. Throws IoError under the same conditions as laz::LazPoints.
std::unique_ptr<CloudSource> open_laz(MappedFile file,
                                      LasHeader header,
                                      CloudFileInfo file_info,
                                      const OpenCloudOptions& options);

}  // namespace ridgeline::io
