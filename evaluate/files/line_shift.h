// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_batches.h"
#include "evaluate/files/judge_files.h"
#include "evaluate/statistics/constant_shift.h"
#include "io/cloud/cloud_files.h"

#include <optional>
#include <vector>

namespace ridgeline::results {

using LineShifts = std::vector<std::optional<evaluate::ConstantShift>>;

/// The shift of each set of judged lines, with its likely cause. Where images chose planes that lie
/// metres off, the lines are judged once more by their own plan, because rays that meet the cloud
/// metres off meet it at another place. `sets`: the lines as read. Throws IoError as
/// judge_in_batches() and likely_cause().
LineShifts shifts_of(const JudgedBatches& judged,
                     const LineSets& lines,
                     const std::vector<io::LineSet>& sets,
                     const JudgeFilesOptions& options,
                     io::CloudFiles& cloud);

/// Moves the lines of each significant shift against it, and marks it as applied.
/// @return whether any lines were moved
bool apply_shifts(LineShifts& shifts, LineSets& lines);

}  // namespace ridgeline::results
