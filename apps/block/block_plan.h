// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/block/patch_grid.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// A file that a block is made of, as it was when it was planned.
struct PlannedFile {
  std::string role;  ///< see results::RunRecord::add_input()
  std::string path;
  std::uint64_t bytes = 0;
  std::int64_t modified_ns = 0;  ///< time of the last change, by the clock of the file system
  std::string sha256;            ///< empty of LIDAR, which is not read whole for the plan
};

/// A frame with the values that become 0 and 1, by band.
struct PlannedFrame {
  PlannedFile file;
  std::string id;
  std::vector<std::array<double, 2>> radiometry;
};

/// A square of the block, and what its task reconstructs.
struct PlannedPatch {
  std::string id;  ///< COLUMN_ROW of its square
  reconstruct::GridCell cell;
  Eigen::AlignedBox2d core_m;  ///< the square within the block's area
  Eigen::AlignedBox2d area_m;  ///< with the overlap
  std::array<double, 2> height_range_m{};
  std::vector<std::string> images;  ///< ids of frames, the base image first
  double windows_mpx = 0.0;         ///< all windows together
  double foreseen_s = 0.0;          ///< processor time of its task
  double foreseen_mib = 0.0;        ///< memory of its task
};

/// How a block is cut into patches: what `--plan` writes and all other steps read.
struct BlockPlan {
  std::string block;  ///< name
  std::string block_file;
  std::string key;  ///< of all that the plan depends on
  std::string crs;
  double patch_size_m = 0.0;
  double overlap_m = 0.0;
  std::vector<Eigen::Vector2d>
      area_m;                         ///< convex, counter-clockwise; empty if the block states none
  Eigen::AlignedBox2d extent_m;       ///< of all squares, with and without views
  std::vector<PlannedFile> inputs;    ///< all but frames
  std::vector<PlannedFrame> frames;   ///< that a patch uses
  std::vector<PlannedPatch> patches;  ///< in the order of their squares
  std::size_t n_without_views = 0;    ///< squares that fewer than two images show
  std::vector<std::string> warnings;
};

/// The squares that the patches belong to.
reconstruct::PatchGrid grid_of(const BlockPlan& plan);

std::string to_json(const BlockPlan& plan);

/// Throws IoError for a file that to_json() did not make.
BlockPlan read_block_plan(const std::string& path);

/// The file as it is now, with its hash if `with_hash`. Throws IoError if it is missing.
PlannedFile planned_file(const std::string& role, const std::string& path, bool with_hash);

/// Throws IoError if the file is missing or not what it was. A new time of change alone is no
/// change, if the hash is known.
void check_unchanged(const PlannedFile& file);

}  // namespace ridgeline::apps
