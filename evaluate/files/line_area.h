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

/// Drops the lines that do not belong to the area, and the decoys made of them, and fills
/// JudgedFiles::areas. A line belongs to the area that has its middle; edges of a model go with
/// their building, and lines without usable coordinates with the middle of all. So each line
/// belongs to one of several areas that cover all lines. A line whose id stands before it in the
/// file repeats it, even if the earlier line is dropped.
void keep_area(const JudgeFilesOptions& options,
               const io::CloudFiles& cloud,
               PreparedLines& prepared,
               DecoySets& decoys);

}  // namespace ridgeline::results
