// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// The smallest 30-bit prefixes of the hashes of a plane's points, ascending; see
/// JudgedResult::inlier_keys. Two planes share as many of their points as of their samples up to
/// the smaller one of both last values.
std::vector<std::uint32_t> point_sample(std::span<const std::uint64_t> point_keys);

/// The lines that one run has judged. Their planes have ids within the run, and samples.
using JudgedRun = std::span<LineEvaluation* const>;

/// Numbers the planes of several runs anew, so that planes of two runs that were fitted to the same
/// points have one id, as BatchJudge gives it to planes of one run. Planes without a sample keep to
/// their run.
void join_planes(std::span<const JudgedRun> runs);

}  // namespace ridgeline::evaluate
