// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/evaluation.h"

#include "reconstruct/geometry/check.h"

#include <map>

namespace ridgeline::evaluate {

Evaluation with_summaries(Evaluation evaluation) {
  evaluation.classes = summarize_classes(evaluation.lines, evaluation.options);
  return evaluation;
}

std::vector<Evaluation> on_common_lines(std::span<const Evaluation> evaluations) {
  std::map<std::string, std::size_t> n_evaluated;
  for (const Evaluation& evaluation : evaluations) {
    check(evaluation.patch == evaluations.front().patch, "on_common_lines: patch ",
          evaluation.patch, " beside patch ", evaluations.front().patch, ", must be one patch");
    for (const LineEvaluation& line : evaluation.lines) {
      if (line.status == Status::kEvaluated) ++n_evaluated[line.id];
    }
  }
  std::vector<Evaluation> result(evaluations.begin(), evaluations.end());
  for (Evaluation& evaluation : result) {
    std::erase_if(evaluation.lines, [&](const LineEvaluation& line) {
      return line.status != Status::kEvaluated || n_evaluated[line.id] != evaluations.size();
    });
    evaluation.decoys.clear();
    evaluation.elsewhere.reset();
    evaluation.completeness.reset();
    evaluation.area.reset();
    evaluation = with_summaries(std::move(evaluation));
  }
  return result;
}

}  // namespace ridgeline::evaluate
