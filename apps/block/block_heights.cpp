// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/block_heights.h"

#include "apps/pipeline/area_heights.h"
#include "reconstruct/geometry/plan_box.h"

namespace ridgeline::apps {

BlockHeights::BlockHeights(const io::BlockFile& block) : block_(block) {
  if (block.height_range_m) {
    all_m_ = *block.height_range_m;
  } else if (block.surface_model) {
    read_model();
  } else {
    read_sample();
  }
}

void BlockHeights::read_model() {
  constexpr double kEverywhere_m = 1e9;
  const Eigen::AlignedBox2d area_m =
      block_.area_m.empty() ? Eigen::AlignedBox2d(Eigen::Vector2d::Constant(-kEverywhere_m),
                                                  Eigen::Vector2d::Constant(kEverywhere_m))
                            : box_around(block_.area_m);
  const io::SurfaceHeights model = model_heights(block_, area_m);
  if (model.heights_m.empty()) refuse_model(block_, area_m);
  all_m_ = height_range_m(model.heights_m);
  warning_ = impossible_heights(block_, model.n_impossible, model.heights_m.size());
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
  warning_ = impossible_heights(block_, lidar.n_impossible, heights_m.size());
}

std::optional<std::array<double, 2>> BlockHeights::range_m(
    const Eigen::AlignedBox2d& area_m) const {
  if (block_.height_range_m) return *block_.height_range_m;
  const std::vector<double> heights_m =
      block_.surface_model ? model_heights(block_, area_m).heights_m : sampled_heights_m(area_m);
  if (heights_m.empty()) return std::nullopt;
  return height_range_m(heights_m);
}

std::vector<double> BlockHeights::sampled_heights_m(const Eigen::AlignedBox2d& area_m) const {
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
  return heights_m;
}

}  // namespace ridgeline::apps
