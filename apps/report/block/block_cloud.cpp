// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/block/block_cloud.h"

#include "io/cloud/cloud_files.h"
#include "io/error.h"
#include "io/files/input_file.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace ridgeline::apps {
namespace {

void require_unchanged(const JudgingCloud& cloud) {
  io::require_regular_file(cloud.path);
  const std::uintmax_t bytes = std::filesystem::file_size(cloud.path);
  if (bytes == cloud.bytes) return;
  throw io::IoError(cloud.path,
                    fmt::format("has changed since the block was judged: {} bytes instead of {}",
                                bytes, cloud.bytes));
}

Eigen::AlignedBox3d box_of(const BlockFolder& block) {
  Eigen::AlignedBox3d box(Eigen::Vector3d::Constant(HUGE_VAL),
                          Eigen::Vector3d::Constant(-HUGE_VAL));
  for (const ShownPatch& patch : block.patches) {
    box.min().head<2>() = box.min().head<2>().cwiseMin(patch.area_m.min());
    box.max().head<2>() = box.max().head<2>().cwiseMax(patch.area_m.max());
  }
  box.min().z() = -HUGE_VAL;
  box.max().z() = HUGE_VAL;
  return box;
}

/// Finds the patches whose area contains a point. Only patches whose squares are near it are
/// tested.
class PatchesAround {
 public:
  explicit PatchesAround(const BlockFolder& block) : block_(block) {
    for (std::size_t i = 0; i < block.patches.size(); ++i) {
      const ShownPatch& patch = block.patches[i];
      patch_of_square_[patch.square] = i;
      const Eigen::Array2d low_m = Eigen::Array2d(static_cast<double>(patch.square[0]),
                                                  static_cast<double>(patch.square[1])) *
                                   block.patch_size_m;
      reach_m_ = std::max({reach_m_, (low_m - patch.area_m.min().array()).maxCoeff(),
                           (patch.area_m.max().array() - low_m - block.patch_size_m).maxCoeff()});
    }
  }

  template <typename Visit>
  void for_each(const Eigen::Vector2d& x_m, const Visit& visit) const {
    const auto low = square_of(x_m - Eigen::Vector2d::Constant(reach_m_));
    const auto high = square_of(x_m + Eigen::Vector2d::Constant(reach_m_));
    for (std::int64_t column = low[0]; column <= high[0]; ++column) {
      for (std::int64_t row = low[1]; row <= high[1]; ++row) {
        const auto found = patch_of_square_.find({column, row});
        if (found != patch_of_square_.end() && block_.patches[found->second].area_m.contains(x_m))
          visit(found->second);
      }
    }
  }

 private:
  [[nodiscard]] std::array<std::int64_t, 2> square_of(const Eigen::Vector2d& x_m) const {
    return {static_cast<std::int64_t>(std::floor(x_m.x() / block_.patch_size_m)),
            static_cast<std::int64_t>(std::floor(x_m.y() / block_.patch_size_m))};
  }

  const BlockFolder& block_;
  double reach_m_ = 0.0;  ///< largest distance by which an area extends beyond its square
  std::map<std::array<std::int64_t, 2>, std::size_t> patch_of_square_;
};

}  // namespace

BlockCloud read_block_cloud(const BlockFolder& block) {
  for (const JudgingCloud& cloud : block.clouds) require_unchanged(cloud);
  io::ReadOptions options;  // as used for judging blocks
  options.frame = LocalFrame{{block.origin_m.x(), block.origin_m.y(), 0.0}};
  io::CloudFiles files(transformed(block.clouds, &JudgingCloud::path), options);
  files.set_bounds(box_of(block));
  const io::PointCloud cloud = files.read_thinned(std::nullopt, kMaxBlockPoints);
  BlockCloud shown;
  shown.n_read = cloud.n_read;
  shown.n_all = cloud.points.size() + cloud.n_dropped_share;
  shown.of_patch.resize(block.patches.size());
  const PatchesAround around(block);
  for (const io::CloudPoint& p : cloud.points) {
    const auto number = static_cast<std::uint32_t>(shown.x_m.size());
    shown.x_m.emplace_back(p.x, p.y, p.z);
    around.for_each(block.origin_m + Eigen::Vector2d(p.x, p.y),
                    [&](std::size_t patch) { shown.of_patch[patch].push_back(number); });
  }
  return shown;
}

std::vector<std::uint32_t> every_kth(const std::vector<std::uint32_t>& numbers,
                                     std::size_t n_most) {
  const std::size_t step = numbers.empty() ? 1 : (numbers.size() + n_most - 1) / n_most;
  std::vector<std::uint32_t> some;
  for (std::size_t i = 0; i < numbers.size(); i += step) some.push_back(numbers[i]);
  return some;
}

}  // namespace ridgeline::apps
