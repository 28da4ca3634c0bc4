// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/block/block_folder.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ridgeline::apps {

/// Maximum number of points held for all pages of a block together, 96 MB.
inline constexpr std::uint64_t kMaxBlockPoints = 4'000'000;
/// Maximum number of points on the page of a patch.
inline constexpr std::size_t kMaxPatchPoints = 20'000;

/// The LIDAR points that the report of a block shows.
struct BlockCloud {
  std::uint64_t n_read = 0;          ///< records in the files
  std::uint64_t n_all = 0;           ///< points within the block among these records
  std::vector<Eigen::Vector3d> x_m;  ///< relative to BlockFolder::origin_m
  std::vector<std::vector<std::uint32_t>>
      of_patch;  ///< for each patch, the indices of the points in its area
};

/// Reads the points within the block, thinned to kMaxBlockPoints. Throws IoError if a cloud cannot
/// be read or if its size differs from that recorded in `run.json`.
BlockCloud read_block_cloud(const BlockFolder& block);

/// Returns every k-th number, so that at most `n_most` remain.
std::vector<std::uint32_t> every_kth(const std::vector<std::uint32_t>& numbers, std::size_t n_most);

}  // namespace ridgeline::apps
