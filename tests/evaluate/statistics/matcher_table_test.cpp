// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/compare/matcher_table.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <vector>

namespace ridgeline::evaluate {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

MatcherFigures figures(const std::string& patch, const std::string& run) {
  MatcherFigures row;
  row.patch = patch;
  row.run = row.matcher = run;
  row.counts = {90, 10, 30};
  row.n_matches = 120;
  row.n_alone = 4;
  row.n_lines = 100;
  row.n_evaluated = 50;
  row.sum_squares_m2 = 50 * 0.09;  // 0.3 m
  row.n_true = 20;
  row.true_sum_squares_m2 = 20 * 0.01;  // 0.1 m
  row.n_true_gross = 1.0;
  row.n_roof_lines = 40;
  row.n_roof_lines_found = 10;
  return row;
}

TEST(MatcherTable, HasTheFiguresOfEveryRun) {
  const std::vector<MatcherFigures> rows{figures("1", "pairwise"), figures("1", "chio")};
  EXPECT_THAT(
      to_markdown(rows),
      AllOf(HasSubstr("| 1 | pairwise | pairwise | 120 | 90 | 10 | 30 | 90.0 | 75.0 | 69.2 | "
                      "4 | 0 | 0.300 (50/100) | 0.100 (20) | 5.0 | 25.0 |"),
            Not(HasSubstr("| all |"))));
}

TEST(MatcherTable, HasTwoBlocksInATerminalMatchesAndLines) {
  const std::vector<MatcherFigures> rows{figures("1", "pairwise"), figures("1", "chio")};
  const std::string text = to_terminal(rows);
  EXPECT_THAT(text, AllOf(HasSubstr("  quality %\n1      pairwise  "),
                          HasSubstr("       69.2\n\npatch  run       "),
                          HasSubstr("  4             0  0.300 (50/100)    0.100 (20)      5.0")));
}

TEST(MatcherTable, PoolsPatchesBySums) {
  std::vector<MatcherFigures> rows{figures("1", "pairwise"), figures("1", "chio"),
                                   figures("2", "pairwise"), figures("2", "chio")};
  rows[2].counts = {10, 0, 0};
  rows[2].n_evaluated = 0;
  rows[2].sum_squares_m2 = 0.0;
  const auto json = nlohmann::json::parse(to_json(rows))["rows"];
  ASSERT_EQ(json.size(), 6U);
  EXPECT_EQ(json[4]["patch"], "all");
  EXPECT_EQ(json[4]["run"], "pairwise");
  EXPECT_EQ(json[4]["correct"], 100);
  EXPECT_NEAR(json[4]["correctness"].get<double>(), 100.0 / 110.0, 1e-12);
  EXPECT_NEAR(json[4]["lidar_rms_m"].get<double>(), 0.3, 1e-12);
  EXPECT_TRUE(json[2]["lidar_rms_m"].is_null());
}

}  // namespace
}  // namespace ridgeline::evaluate
