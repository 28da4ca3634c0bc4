// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/block_heights.h"

#include "apps/pipeline/area_heights.h"
#include "reconstruct/geometry/plan_box.h"

namespace ridgeline::apps {

BlockHeights::BlockHeights(const io::BlockFile& block) : block_(block) {
  if (!block.height_range_m && !block.surface_model) read_sample();
}

void BlockHeights::read_sample() {
  const LidarSample lidar = lidar_sample(block_, block_.overlap_m);
  if (lidar.points_in_world.empty()) refuse_lidar(block_, lidar, "in the area");
  std::vector<double> heights_m;
  heights_m.reserve(lidar.points_in_world.size());
  for (const Eigen::Vector3d& x : lidar.points_in_world) {
    extent_m_.extend(Eigen::Vector2d(x.head<2>()));
    points_[bins_.cell_of(x.head<2>())].push_back(x);
    heights_m.push_back(x.z());
  }
  all_m_ = height_range_m(heights_m);
}

std::array<double, 2> BlockHeights::range_m(const Eigen::AlignedBox2d& area_m) const {
  if (block_.height_range_m) return *block_.height_range_m;
  if (block_.surface_model) return height_range_m(model_heights_m(block_, corners_of(area_m)));
  std::vector<double> heights_m;
  const reconstruct::GridCell first = bins_.cell_of(area_m.min());
  const reconstruct::GridCell last = bins_.cell_of(area_m.max());
  for (std::int64_t column = first.column; column <= last.column; ++column) {
    for (std::int64_t row = first.row; row <= last.row; ++row) {
      const auto bin = points_.find({column, row});
      if (bin == points_.end()) continue;
      for (const Eigen::Vector3d& x : bin->second) {
        if (area_m.contains(Eigen::Vector2d(x.head<2>()))) heights_m.push_back(x.z());
      }
    }
  }
  return heights_m.empty() ? all_m_ : height_range_m(heights_m);
}

}  // namespace ridgeline::apps
