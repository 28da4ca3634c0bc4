// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_batches.h"
#include "evaluate/files/judge_files.h"
#include "evaluate/files/run_record.h"
#include "io/cloud/cloud_files.h"
#include "reconstruct/geometry/segment.h"

#include <vector>

namespace ridgeline::results {

/// The lines of each file that may find edges of the scan: those with a position.
std::vector<std::vector<Segment3>> finding_lines(const LineSets& lines);

/// Finds the edges of the scan in the area of the lines (scan_area()) and compares each file with
/// them: fills in Evaluation::completeness and, for models, what the buildings lack.
/// @param lines  finding_lines() of all lines, as given
/// Throws IoError under the same conditions as edges_of_cloud().
void compare_files_with_scan(std::vector<std::vector<Segment3>> lines,
                             io::CloudFiles& cloud,
                             const JudgeFilesOptions& options,
                             RunRecord& record,
                             JudgedFiles& judged);

}  // namespace ridgeline::results
