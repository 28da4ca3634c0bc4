// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/bytes.h"
#include "io/cloud/cloud_source.h"
#include "io/cloud/las_source.h"
#include "io/cloud/mapped_file.h"
#include "io/cloud/pcd_source.h"
#include "io/cloud/ply_source.h"
#include "io/cloud/xyz_source.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace ridgeline::io {

std::unique_ptr<CloudSource> open_cloud(const std::string& path, const OpenCloudOptions& options) {
  MappedFile file(path);
  const std::span<const std::byte> bytes = file.bytes();
  const std::string start = load_text(bytes.first(std::min<std::size_t>(bytes.size(), 8)));
  if (start.starts_with("ply") && start.size() > 3 &&
      std::isspace(static_cast<unsigned char>(start[3])) != 0) {
    return open_ply(std::move(file), path);
  }
  if (start.starts_with("# .PCD") || start.starts_with("VERSION")) {
    return open_pcd(std::move(file), path);
  }
  if (!start.starts_with("LASF") && has_xyz_name(path)) return open_xyz(std::move(file), path);
  // Whatever else it is, the LAS reader says best what is wrong with it.
  return open_las(std::move(file), path, options);
}

}  // namespace ridgeline::io
