// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/judged_parts.h"

#include "evaluate/judge/batch_judge.h"
#include "reconstruct/geometry/transformed.h"

#include <utility>

namespace ridgeline::results {

LineSets lines_of(const LineSets& lines, const LineNumbers& numbers) {
  LineSets some(numbers.size());
  for (std::size_t set = 0; set < numbers.size(); ++set) {
    some[set] = transformed(numbers[set], [&](std::size_t i) { return lines[set][i]; });
  }
  return some;
}

JudgedParts::JudgedParts(const LineSets& lines) : lines_(lines) {
  for (const auto& set : lines) all_.results.emplace_back(set.size());
}

void JudgedParts::add(const LineNumbers& numbers, JudgedBatches part) {
  for (std::size_t set = 0; set < numbers.size(); ++set) {
    for (std::size_t k = 0; k < numbers[set].size(); ++k) {
      all_.results[set][numbers[set][k]] = std::move(part.results[set][k]);
    }
  }
  results::add(std::move(part.readings), all_.readings);
}

JudgedBatches JudgedParts::join(io::CloudFiles& cloud,
                                const evaluate::JudgeOptions& options,
                                std::uint64_t max_memory_bytes) {
  // Without any point the headers of the cloud may be wrong, which only a judge of all lines can
  // find out.
  if (all_.readings.n_kept == 0) {
    return judge_in_batches(cloud, lines_, options, max_memory_bytes);
  }
  cloud.count_as_read(all_.readings.read_places);
  cloud.sort_warnings(all_.readings.cloud.warnings);
  for (std::size_t set = 0; set < lines_.size(); ++set) {
    evaluate::join_parts(lines_[set], all_.results[set]);
  }
  return std::move(all_);
}

}  // namespace ridgeline::results
