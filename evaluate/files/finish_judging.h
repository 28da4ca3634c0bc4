// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_batches.h"
#include "evaluate/files/judge_files.h"
#include "evaluate/files/prepare_lines.h"
#include "evaluate/files/run_record.h"
#include "io/cloud/cloud_files.h"

namespace ridgeline::results {

/// The tolerance of check_frame(): lines with a median distance above 20 times this are not in the
/// frame of the cloud. This detects a geoid mistaken for an ellipsoid (tens of metres), while lines
/// that are a storey too high are still judged.
inline constexpr double kFrameTolerance_m = 1.0;

/// The last step of judge_lines(), which needs all lines: it estimates their shift, computes the
/// figures, checks the frame, and warns about suspicious values. With
/// JudgeFilesOptions::apply_shift it judges the lines again. `batches`: the result of
/// judge_in_batches() for the prepared lines. Throws IoError under the same conditions as
/// judge_files().
JudgedFiles finish_judging(PreparedLines prepared,
                           JudgedBatches batches,
                           io::CloudFiles& cloud,
                           const JudgeFilesOptions& options,
                           RunRecord& record);

}  // namespace ridgeline::results
