// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/batch_judge.h"

#include "evaluate/judge/plane_ids.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/interruption.h"

#include <tbb/parallel_for.h>

#include <string>
#include <unordered_set>
#include <utility>

namespace ridgeline::evaluate {
namespace {

std::vector<char> repeated_ids(std::span<const JudgedLine> lines) {
  std::unordered_set<std::string> seen;
  std::vector<char> repeated(lines.size(), 0);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    repeated[i] = seen.insert(lines[i].id).second && !lines[i].repeats_id ? 0 : 1;
  }
  return repeated;
}

JudgedResult duplicate(const JudgedLine& line) {
  JudgedResult result;
  result.evaluation.id = line.id;
  result.evaluation.line_class = line.line_class;
  result.evaluation.building = line.building;
  result.evaluation.epipolar_angle_deg = line.epipolar_angle_deg;
  result.evaluation.n_images = line.n_images;
  result.evaluation.class_base = line.class_base;
  if (line.n_images && in_range(line.segment)) result.evaluation.segment = line.segment;
  result.evaluation.status = Status::kDuplicateId;
  result.evaluation.reason = "an earlier line has the same id";
  if (in_range(line.segment)) result.evaluation.length_m = length(line.segment);
  return result;
}

}  // namespace

BatchJudge::BatchJudge(std::span<const JudgedLine> lines, const JudgeOptions& options)
    : lines_(lines), options_(options), repeated_(repeated_ids(lines)), results_(lines.size()) {
  validate(options);
}

void BatchJudge::judge(const PointSearch& search, std::span<const std::size_t> batch) {
  tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t k) {
    Interruption::check();
    const std::size_t i = batch[k];
    results_[i] =
        repeated_[i] != 0 ? duplicate(lines_[i]) : judge_line(search, lines_[i], options_);
  });
}

std::vector<JudgedResult> BatchJudge::take_results() {
  find_shared_points(results_);
  std::vector<LineEvaluation*> lines;
  for (JudgedResult& result : results_) lines.push_back(&result.evaluation);
  identify_planes(lines);
  return std::move(results_);
}

std::vector<JudgedResult> BatchJudge::take_without_ids() { return std::move(results_); }

}  // namespace ridgeline::evaluate
