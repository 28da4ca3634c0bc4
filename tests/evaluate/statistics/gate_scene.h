// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/gates/gate.h"
#include "tests/evaluate/statistics/lines.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {

/// Results with 30 lines a class: not_aligned lines are 0.1 m off, aligned ones `aligned_m`. 5 more
/// lines are excluded.
inline ResultFolder results_with(double aligned_m, const std::string& method = "joint") {
  Evaluation e;
  e.patch = "1";
  e.method = method;
  for (int i = 0; i < 30; ++i) {
    const std::string id = std::to_string(i);
    e.lines.push_back(evaluated_line("n" + id, i % 2 == 0 ? 0.1 : -0.1, i + 1));
    e.lines.push_back(evaluated_line("a" + id, aligned_m, i + 1, "aligned"));
  }
  for (LineEvaluation& line : e.lines) {
    line.displacement = RidgeDisplacement{.horizontal_m = 0.1, .vertical_m = 0.1};
  }
  for (int i = 0; i < 5; ++i) {
    e.lines.push_back(excluded_line("x" + std::to_string(i), Status::kNoPlane));
  }
  ResultFolder folder;
  folder.name = "results";
  folder.evaluations.push_back(with_summaries(std::move(e)));
  folder.matching.rows = {{"1", "pairwise", {90, 10, 10}}};
  folder.input_hashes = {{"lidar.las", "ab12"}};
  return folder;
}

inline Gate gate_on(const std::string& line_class, const std::string& metric = "rms_m") {
  Gate gate;
  gate.line_class = line_class;
  gate.metric = metric;
  return gate;
}

inline GateResult only_result(const Gate& gate,
                              const ResultFolder& results,
                              const ResultFolder* baseline = nullptr) {
  const GateReport report = apply_gates(std::vector{gate}, results, baseline);
  EXPECT_EQ(report.results.size(), 1U);
  return report.results.at(0);
}

}  // namespace ridgeline::evaluate
