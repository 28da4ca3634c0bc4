// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/bytes.h"
#include "io/cloud/cloud_source.h"
#include "io/cloud/las_source.h"
#include "io/cloud/pcd_source.h"
#include "io/cloud/ply_source.h"
#include "io/cloud/xyz_source.h"
#include "io/error.h"
#include "io/files/mapped_file.h"
#include "io/kinds/folder_kind.h"
#include "io/kinds/recognise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>
#include <utility>

namespace ridgeline::io {
namespace {

void require_file(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) return;
  const FileKind kind = kind_of_folder(path);
  throw IoError(path, fmt::format("is not a regular file but {}; {}", kind.what,
                                  kind.advice.empty() ? "a point cloud is expected" : kind.advice));
}

}  // namespace

std::unique_ptr<CloudSource> open_cloud(const std::string& path, const OpenCloudOptions& options) {
  require_file(path);
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
  if (start.starts_with("LASF")) return open_las(std::move(file), path, options);
  require_kind(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()},
               FileGroup::kCloud);
  if (has_xyz_name(path)) return open_xyz(std::move(file), path);
  // Any other file goes to the LAS reader, which gives the best error message.
  return open_las(std::move(file), path, options);
}

}  // namespace ridgeline::io
