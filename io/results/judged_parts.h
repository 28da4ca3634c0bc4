// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judge_line.h"
#include "evaluate/judge/options.h"
#include "io/cloud/cloud_files.h"
#include "io/results/judge_batches.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ridgeline::results {

/// Some of all lines: for each set the numbers of its lines.
using LineNumbers = std::vector<std::vector<std::size_t>>;

/// The lines of these numbers.
LineSets lines_of(const LineSets& lines, const LineNumbers& numbers);

/// Puts what judge_part() gave for parts of the lines together.
class JudgedParts {
 public:
  /// `lines`: all lines, which must outlive the object.
  explicit JudgedParts(const LineSets& lines);

  /// Adds a part with the numbers of its lines. Every line belongs to one part.
  void add(const LineNumbers& numbers, JudgedBatches part);

  /// What judge_in_batches() gives for all lines, bit by bit, but for the number of batches and the
  /// counts of points. To be called once, after the last part. `cloud` has read what the parts have
  /// read.
  JudgedBatches join(io::CloudFiles& cloud,
                     const evaluate::JudgeOptions& options,
                     std::uint64_t max_memory_bytes);

 private:
  const LineSets& lines_;
  JudgedBatches all_;
};

}  // namespace ridgeline::results
