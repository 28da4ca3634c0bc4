// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judge_line.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// Judges lines batch by batch, each batch against a part of a cloud that contains all points near
/// its lines, so that the cloud need not fit into memory. The results are bit-identical to those of
/// judge_lines() with the whole cloud, however lines and points are divided.
class BatchJudge {
 public:
  /// `lines` must outlive the object. Throws std::invalid_argument for an option out of its range.
  BatchJudge(std::span<const JudgedLine> lines, const JudgeOptions& options);

  /// Judges the lines of a batch, given by their numbers, in parallel. Every line belongs to one
  /// batch.
  void judge(const PointSearch& search, std::span<const std::size_t> batch);

  /// The results; call once, after the last batch. The i-th result belongs to the i-th line; see
  /// judge_lines().
  std::vector<JudgedResult> take_results();

  /// Alternative to take_results(): the same results, but without plane ids.
  std::vector<JudgedResult> take_without_ids();

 private:
  std::span<const JudgedLine> lines_;
  JudgeOptions options_;
  std::vector<char> repeated_;
  std::vector<JudgedResult> results_;
};

}  // namespace ridgeline::evaluate
