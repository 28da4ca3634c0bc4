// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/library_versions.h"

#include <gdal.h>
#include <proj.h>

namespace ridgeline::io {

std::vector<std::pair<std::string, std::string>> library_versions() {
  return {{"gdal", GDALVersionInfo("RELEASE_NAME")}, {"proj", proj_info().version}};
}

}  // namespace ridgeline::io
