// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/block_file.h"
#include "reconstruct/scene/patch_grid.h"

#include <Eigen/Geometry>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The height ranges to be searched for the patches of a block.
class BlockHeights {
 public:
  /// Reads a sample of the LIDAR or the surface model if the block derives its heights from it.
  /// Throws IoError if it has no height in the area of the block.
  explicit BlockHeights(const io::BlockFile& block);

  /// The heights stated by the block, else the lowest and highest height in the area with
  /// kHeightMargin_m on both sides; std::nullopt for an area without heights.
  [[nodiscard]] std::optional<std::array<double, 2>> range_m(
      const Eigen::AlignedBox2d& area_m) const;

  /// The same for the whole block.
  [[nodiscard]] const std::array<double, 2>& whole_range_m() const { return all_m_; }

  /// The bounding box of the sample in plan; empty if none was read.
  [[nodiscard]] const Eigen::AlignedBox2d& extent_m() const { return extent_m_; }

  /// See impossible_heights().
  [[nodiscard]] const std::optional<std::string>& warning() const { return warning_; }

 private:
  void read_sample();
  void read_model();
  [[nodiscard]] std::vector<double> sampled_heights_m(const Eigen::AlignedBox2d& area_m) const;

  const io::BlockFile& block_;
  Eigen::AlignedBox2d extent_m_;
  reconstruct::PatchGrid bins_{10.0};
  std::map<reconstruct::GridCell, std::vector<Eigen::Vector3d>> points_;  ///< of the sample, by bin
  std::array<double, 2> all_m_{};
  std::optional<std::string> warning_;
};

}  // namespace ridgeline::apps
