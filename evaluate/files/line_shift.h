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

/// The shift of each set of judged lines, with its likely cause. If the lines of a set with image
/// evidence are metres off, they are judged again from their own position in plan, because their
/// rays meet the cloud in the wrong place. `sets`: the lines as read. Throws IoError under the same
/// conditions as judge_in_batches() and likely_cause().
LineShifts shifts_of(const JudgedBatches& judged,
                     const LineSets& lines,
                     const std::vector<io::LineSet>& sets,
                     const JudgeFilesOptions& options,
                     io::CloudFiles& cloud);

/// Removes each significant shift from its lines and marks it as applied.
/// @return whether any lines were moved
bool apply_shifts(LineShifts& shifts, LineSets& lines);

}  // namespace ridgeline::results
