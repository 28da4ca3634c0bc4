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

  /// The same results for lines that are a part of all, to be taken instead. Planes have no ids
  /// yet; see join_parts().
  std::vector<JudgedResult> take_part();

 private:
  std::span<const JudgedLine> lines_;
  JudgeOptions options_;
  std::vector<char> repeated_;
  std::vector<JudgedResult> results_;
};

/// Makes the results of lines that were judged part by part, each part by a BatchJudge of its own,
/// those of judge_lines(): later lines of an id become `duplicate_id`, planes get their ids.
/// `results` holds one for each line. Throws std::invalid_argument if it does not.
void join_parts(std::span<const JudgedLine> lines, std::vector<JudgedResult>& results);

}  // namespace ridgeline::evaluate
