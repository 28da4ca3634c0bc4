// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_batches.h"
#include "evaluate/files/prepare_lines.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace ridgeline::results {

/// JudgeFilesOptions::area in local metres. Its upper sides are not in it.
Eigen::AlignedBox2d area_in_local(const Eigen::AlignedBox2d& area, const io::CloudFiles& cloud);

/// The numbers of the buildings of a model that belong to an area: those whose outline has its
/// middle there. A building without faces counts where the middle of all is.
std::vector<std::size_t> buildings_in(const Eigen::AlignedBox2d& area_in_local,
                                      const io::LineSet& set,
                                      const LocalFrame& frame);

/// The lines of a file that are judged for an area: its own and their neighbours.
struct AreaLines {
  std::vector<std::size_t> numbers;  ///< in the file, ascending
  std::vector<bool> is_own;          ///< of each of these
};

/// Drops the lines that neither belong to the area nor can share points with one that does, and the
/// decoys made of lines that do not belong to it, and fills JudgedFiles::areas. A line belongs to
/// the area that has its middle; edges of a model go with their building, and lines without usable
/// coordinates with the middle of all. So each line belongs to one of several areas that cover all
/// lines. A line whose id an earlier one in the file has repeats it, even if that one is dropped.
std::vector<AreaLines> keep_area(const JudgeFilesOptions& options,
                                 const io::CloudFiles& cloud,
                                 PreparedLines& prepared,
                                 DecoySets& decoys);

/// Drops the neighbours once they are judged. JudgingPlane::points then name lines by their numbers
/// in the file. `kept`: what keep_area() gave.
void drop_neighbours(const std::vector<AreaLines>& kept,
                     PreparedLines& prepared,
                     JudgedBatches& batches);

}  // namespace ridgeline::results
