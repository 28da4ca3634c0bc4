// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/pipeline/made_from.h"
#include "reconstruct/scene/patch_grid.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// A frame with the values that map to 0 and 1, by band.
struct PlannedFrame {
  FileState file;
  std::string id;
  std::vector<std::array<double, 2>> radiometry;
};

/// A square of the block and the inputs of its task.
struct PlannedPatch {
  std::string id;  ///< COLUMN_ROW of its square
  reconstruct::GridCell cell;
  Eigen::AlignedBox2d core_m;  ///< the square within the block's area
  Eigen::AlignedBox2d area_m;  ///< with the overlap
  std::array<double, 2> height_range_m{};
  std::vector<std::string> images;  ///< ids of frames, the base image first
  double windows_mpx = 0.0;         ///< total of all windows
  double estimated_s = 0.0;         ///< processor time of its task
  double estimated_mib = 0.0;       ///< memory of its task
};

/// The division of a block into patches: written by `--plan`, read by all other steps.
struct BlockPlan {
  std::string block;  ///< name
  std::string block_file;
  std::string key;  ///< of everything on which the plan depends
  std::string crs;
  double patch_size_m = 0.0;
  double overlap_m = 0.0;
  std::vector<Eigen::Vector2d> area_m;  ///< convex, counter-clockwise; empty if not stated
  Eigen::AlignedBox2d extent_m;         ///< of all squares, with and without views
  std::vector<FileState> inputs;        ///< all except frames
  std::vector<PlannedFrame> frames;     ///< used by a patch
  std::vector<PlannedPatch> patches;    ///< in the order of their squares
  std::size_t n_without_views = 0;      ///< squares shown in fewer than two images
  std::vector<std::string> warnings;
};

/// The grid of the squares of the patches.
reconstruct::PatchGrid grid_of(const BlockPlan& plan);

std::string to_json(const BlockPlan& plan);

/// Throws IoError for a file that is not output of to_json().
BlockPlan read_block_plan(const std::string& path);

/// Throws IoError unless is_unchanged().
void require_unchanged(const FileState& file);

}  // namespace ridgeline::apps
