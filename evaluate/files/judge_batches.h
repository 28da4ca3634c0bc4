// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judge_line.h"
#include "evaluate/judge/options.h"
#include "evaluate/statistics/decoy_figures.h"
#include "evaluate/statistics/decoys.h"
#include "io/cloud/cloud_files.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ridgeline::results {

using LineSets = std::vector<std::vector<evaluate::JudgedLine>>;
using DecoySets = std::vector<std::vector<evaluate::Decoy>>;

/// What the readings of a cloud gave, summed over them: a point near the lines of two batches
/// counts twice.
struct CloudReadings {
  std::size_t n_batches = 0;
  std::uint64_t n_kept = 0;
  io::PointCloud cloud;  ///< without points: reference system, units, counts, warnings
};

struct JudgedBatches {
  std::vector<std::vector<evaluate::JudgedResult>> results;  ///< by set, by line
  CloudReadings readings;
  std::vector<std::vector<evaluate::JudgedDecoy>> decoys;  ///< by set; empty if none were made
};

/// The box in plan around all points that planes of a line can be fitted to; empty for a line that
/// cannot be judged.
Eigen::AlignedBox2d surroundings_of(const evaluate::JudgedLine& line,
                                    const evaluate::JudgeOptions& options);

/// Judges every line by the points near it. If these need more memory than `max_memory_bytes` for
/// all lines together, the lines are judged in batches of neighbours, halved until their points
/// fit, and the cloud's files are read for each; the results are the same, bit by bit. The
/// surroundings of a single line are read whatever they need, with a warning if that is more.
/// `decoys`: lines made of those of each set, which are judged in the same readings of the cloud;
/// empty for none. They change no result, but count in the readings. Bounds in headers of the cloud
/// are not trusted if no line has points near it, unless these are not `all_lines`. Throws IoError
/// as read_cloud().
JudgedBatches judge_in_batches(io::CloudFiles& cloud,
                               const LineSets& lines,
                               const evaluate::JudgeOptions& options,
                               std::uint64_t max_memory_bytes,
                               DecoySets decoys = {},
                               bool all_lines = true);

}  // namespace ridgeline::results
