// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/block_heights.h"

#include "apps/pipeline/area_heights.h"
#include "io/cloud/cloud_files.h"
#include "io/error.h"
#include "reconstruct/geometry/plan_box.h"

#include <fmt/format.h>

namespace ridgeline::apps {

BlockHeights::BlockHeights(const io::PatchFile& block, double overlap_m) : block_(block) {
  if (block.heights == io::HeightSource::kLidar) read_sample(overlap_m);
}

void BlockHeights::read_sample(double overlap_m) {
  constexpr std::uint64_t kMaxPoints = 2'000'000;
  constexpr double kFar_m = 1e5;  // beyond all heights on Earth
  io::CloudFiles files(block_.lidar, {});
  if (!block_.area_m.empty()) {
    const Eigen::AlignedBox2d plan = grown(box_around(block_.area_m), overlap_m);
    files.set_bounds({Eigen::Vector3d(plan.min().x(), plan.min().y(), -kFar_m),
                      Eigen::Vector3d(plan.max().x(), plan.max().y(), kFar_m)});
  }
  const io::PointCloud cloud = files.read_thinned(std::nullopt, kMaxPoints);
  std::vector<double> heights_m;
  heights_m.reserve(cloud.points.size());
  for (const io::CloudPoint& point : cloud.points) {
    const Eigen::Vector3d x = Eigen::Vector3d(point.x, point.y, point.z) + cloud.frame.origin_m;
    extent_m_.extend(Eigen::Vector2d(x.head<2>()));
    points_[bins_.cell_of(x.head<2>())].push_back(x);
    heights_m.push_back(x.z());
  }
  if (heights_m.empty()) {
    const io::CrsAgreement agreement = io::compare(block_.crs, cloud.crs);
    throw io::IoError(block_.path,
                      fmt::format("height_range: auto: no LIDAR point lies in the area{}{}",
                                  agreement.compatible ? "" : "; ", agreement.reason));
  }
  const auto [low, high] = height_limits_m(heights_m);
  all_m_ = {low - kHeightMargin_m, high + kHeightMargin_m};
}

std::array<double, 2> BlockHeights::range_m(const Eigen::AlignedBox2d& area_m) const {
  if (block_.heights == io::HeightSource::kStated) return block_.height_range_m;
  if (block_.heights == io::HeightSource::kSurfaceModel) {
    io::PatchFile patch;
    patch.path = block_.path;
    patch.crs = block_.crs;
    patch.heights = block_.heights;
    patch.surface_model = block_.surface_model;
    patch.area_m = corners_of(area_m);
    return area_heights(patch).range_m;
  }
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
  if (heights_m.empty()) return all_m_;
  const auto [low, high] = height_limits_m(heights_m);
  return {low - kHeightMargin_m, high + kHeightMargin_m};
}

}  // namespace ridgeline::apps
