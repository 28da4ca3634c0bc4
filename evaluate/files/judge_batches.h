// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/cloud_readings.h"
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

struct JudgedBatches {
  std::vector<std::vector<evaluate::JudgedResult>> results;  ///< by set and line
  CloudReadings readings;
  std::vector<std::vector<evaluate::JudgedDecoy>> decoys;  ///< by set; empty if none were made
};

/// The bounding box in plan of all points that may be used to fit the planes of a line; empty for a
/// line that cannot be judged.
Eigen::AlignedBox2d surroundings_of(const evaluate::JudgedLine& line,
                                    const evaluate::JudgeOptions& options);

/// Judges every line by the points near it. If the points near all lines need more memory than
/// `max_memory_bytes`, the lines are judged in batches of neighbours, which are halved until their
/// points fit, and the cloud's files are read once per batch; the results are bit-identical. The
/// points near a single line are read even if they exceed the limit, with a warning. `decoys`:
/// moved copies of the lines, by set, judged in the same readings of the cloud; may be empty. They
/// do not affect the results of the lines, but their points count in the readings. If no line has
/// points near it, the bounds in the headers of the cloud are not trusted, unless `all_lines` is
/// false. Throws IoError under the same conditions as read_cloud().
JudgedBatches judge_in_batches(io::CloudFiles& cloud,
                               const LineSets& lines,
                               const evaluate::JudgeOptions& options,
                               std::uint64_t max_memory_bytes,
                               DecoySets decoys = {},
                               bool all_lines = true);

}  // namespace ridgeline::results
