// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_batches.h"
#include "evaluate/files/judge_files.h"
#include "evaluate/statistics/reference_errors.h"
#include "io/cloud/cloud_files.h"

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::results {

/// Lines ready to be judged, in the frame and the units of the cloud.
struct PreparedLines {
  JudgedFiles judged;  ///< filled so far: lines as read, frame, warnings
  LineSets lines;
  std::optional<std::vector<evaluate::ReferenceLine>> references;
  std::vector<std::string> reference_warnings;
};

/// Reads the lines and true lines named in the options. Throws IoError like read_lines(), and for
/// two line files with the same name.
LinesToJudge read_lines_to_judge(const JudgeFilesOptions& options);

/// The first step of judge_lines(). Throws IoError for a CRS or unit mismatch.
PreparedLines prepare_lines(LinesToJudge to_judge,
                            io::CloudFiles& cloud,
                            const JudgeFilesOptions& options);

}  // namespace ridgeline::results
