// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judge_line.h"

#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// Judges lines batch by batch, each against a part of a cloud that holds all points near the lines
/// of the batch, so that the cloud need not fit into memory. The results are those of judge_lines()
/// with the whole cloud, bit by bit, however lines and points are divided.
class BatchJudge {
 public:
  /// `lines` must outlive the object. Throws std::invalid_argument for an option out of its range.
  BatchJudge(std::span<const JudgedLine> lines, const JudgeOptions& options);

  /// Judges the lines of a batch, by their numbers, in parallel. Every line belongs to one batch.
  void judge(const PointSearch& search, std::span<const std::size_t> batch);

  /// The results, to be taken once, after the last batch. The i-th belongs to the i-th line; see
  /// judge_lines().
  std::vector<JudgedResult> take_results();

  /// The same results, to be taken instead, whose planes have no ids.
  std::vector<JudgedResult> take_without_ids();

 private:
  std::span<const JudgedLine> lines_;
  JudgeOptions options_;
  std::vector<char> repeated_;
  std::vector<JudgedResult> results_;
};

}  // namespace ridgeline::evaluate
