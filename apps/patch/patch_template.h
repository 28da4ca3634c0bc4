// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The content of a new patch file. Empty texts and lists are left out; paths are absolute or
/// relative to the working folder.
struct PatchTemplate {
  std::string id;
  std::string crs;
  std::string orientation, cameras;
  std::string angles, rotation, matrix;
  std::string images;          ///< folder or pattern
  std::string area_file;       ///< instead of area_m
  std::vector<double> area_m;  ///< x_min, y_min, x_max, y_max
  std::size_t max_views = 0;
  std::vector<double> height_range_m;  ///< empty: auto
  std::string surface_model;
  std::vector<std::string> lidar;
};

/// The text of a patch file with comments; its paths are relative to `folder` where possible.
std::string patch_text(const PatchTemplate& patch, const std::string& folder);

}  // namespace ridgeline::apps
