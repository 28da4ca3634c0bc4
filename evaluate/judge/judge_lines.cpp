// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/judge_lines.h"

#include "evaluate/judge/batch_judge.h"

#include <numeric>

namespace ridgeline::evaluate {

std::vector<JudgedResult> judge_lines(const PointSearch& search,
                                      std::span<const JudgedLine> lines,
                                      const JudgeOptions& options) {
  BatchJudge judge(lines, options);
  std::vector<std::size_t> all(lines.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  judge.judge(search, all);
  return judge.take_results();
}

}  // namespace ridgeline::evaluate
