// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/las_writer.h"
#include "io/cloud/read_cloud.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace ridgeline::test {

/// Cuts a cloud at whole multiples of `tile_m` in its local frame into FOLDER/COLUMN_ROW.las. All
/// points are kept.
inline void cut_cloud(const std::filesystem::path& cloud_file,
                      const std::filesystem::path& folder,
                      double tile_m) {
  io::ReadOptions all;
  all.classes.emplace();
  for (int code = 0; code < 256; ++code) all.classes->insert(static_cast<std::uint8_t>(code));
  all.exclude_withheld = false;
  const io::PointCloud cloud = io::read_cloud({cloud_file.string()}, all);
  std::map<std::array<int, 2>, std::vector<io::CloudPoint>> tiles;
  for (const io::CloudPoint& p : cloud.points) {
    tiles[{static_cast<int>(std::floor(p.x / tile_m)), static_cast<int>(std::floor(p.y / tile_m))}]
        .push_back(p);
  }
  std::filesystem::create_directories(folder);
  for (const auto& [key, points] : tiles) {
    const std::string name = std::to_string(key[0]) + "_" + std::to_string(key[1]) + ".las";
    io::write_las((folder / name).string(), points, cloud.frame, cloud.crs);
  }
}

}  // namespace ridgeline::test
