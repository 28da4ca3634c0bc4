// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/block/block_folder.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ridgeline::apps {

/// Most points that are held for all pages of a block together, 96 MB.
inline constexpr std::uint64_t kMaxBlockPoints = 4'000'000;
/// Most points on the page of one patch.
inline constexpr std::size_t kMaxPatchPoints = 20'000;

/// The LIDAR of a block as its report shows it.
struct BlockCloud {
  std::uint64_t n_read = 0;          ///< records in the files
  std::uint64_t n_all = 0;           ///< of these, points within the block
  std::vector<Eigen::Vector3d> x_m;  ///< relative to BlockFolder::origin_m
  std::vector<std::vector<std::uint32_t>>
      of_patch;  ///< numbers of the points in the area of each patch
};

/// Reads the points within the block, thinned to kMaxBlockPoints. Throws IoError for clouds that
/// cannot be read, and for those whose size is no longer that of `run.json`.
BlockCloud read_block_cloud(const BlockFolder& block);

/// Every k-th of the numbers, so that at most `n_most` stay.
std::vector<std::uint32_t> every_kth(const std::vector<std::uint32_t>& numbers, std::size_t n_most);

}  // namespace ridgeline::apps
