// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_batches.h"
#include "evaluate/files/prepare_lines.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace ridgeline::results {

/// JudgeFilesOptions::area in local metres. Its upper sides do not belong to it.
Eigen::AlignedBox2d area_in_local(const Eigen::AlignedBox2d& area, const io::CloudFiles& cloud);

/// The numbers of the buildings of a model that belong to an area: those whose outline has its
/// centre in it. A building without faces belongs to the area that contains the centre of all
/// buildings.
std::vector<std::size_t> buildings_in(const Eigen::AlignedBox2d& area_in_local,
                                      const io::LineSet& set,
                                      const LocalFrame& frame);

/// The lines of a file that are judged for an area: its own lines and their neighbours.
struct AreaLines {
  std::vector<std::size_t> numbers;  ///< in the file, ascending
  std::vector<bool> is_own;          ///< of each of these
};

/// Drops the lines that neither belong to the area nor can share points with one that does, drops
/// the decoys of lines that do not belong to it, and fills JudgedFiles::areas. A line belongs to
/// the area that contains its midpoint; edges of a model belong with their building, and lines
/// without usable coordinates to the area that contains the centre of all lines. Each line
/// therefore belongs to one of several areas that together cover all lines. A line with the same id
/// as an earlier line of the file counts as a repetition even if the earlier line is dropped.
std::vector<AreaLines> keep_area(const JudgeFilesOptions& options,
                                 const io::CloudFiles& cloud,
                                 PreparedLines& prepared,
                                 DecoySets& decoys);

/// Drops the neighbours once they are judged. Afterwards JudgingPlane::points refer to lines by
/// their numbers in the file. `kept`: the result of keep_area().
void drop_neighbours(const std::vector<AreaLines>& kept,
                     PreparedLines& prepared,
                     JudgedBatches& batches);

}  // namespace ridgeline::results
