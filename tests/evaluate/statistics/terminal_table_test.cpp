// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/tables/terminal_table.h"

#include "tests/evaluate/statistics/lines.h"

#include <gmock/gmock.h>

#include <sstream>

namespace ridgeline::evaluate {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

Evaluation evaluation_of(const std::string& patch, const std::string& method) {
  Evaluation e;
  e.patch = patch;
  e.method = method;
  for (int i = 0; i < 12; ++i) e.lines.push_back(evaluated_line(std::to_string(i), 0.1, i + 1));
  return with_summaries(std::move(e));
}

TEST(TerminalTable, HasAlignedColumnsWithoutMarkup) {
  const std::string text = to_terminal(make_table2(
      std::vector{evaluation_of("1", "direct"), evaluation_of("H\xC3\xA4user", "joint")}));
  EXPECT_THAT(text, Not(HasSubstr("|")));
  std::istringstream rows(text);
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "Distances of the lines from LIDAR planes, m");
  std::getline(rows, row);
  const std::size_t end_of_rms = row.find("RMS") + 3;
  std::getline(rows, row);
  EXPECT_EQ(row.substr(end_of_rms - 5, 5), "0.100");
  while (std::getline(rows, row) && row.find("half of") == std::string::npos) {
    const std::size_t n_wide = row.find("\xC3\xA4") == std::string::npos ? 0 : 1;
    EXPECT_THAT(row.substr(end_of_rms + n_wide - 5, 5), testing::AnyOf("0.100", "    -")) << row;
  }
}

TEST(TerminalTable, ShowsThePartsOfRidgesWhereThereAreRidges) {
  Evaluation e = evaluation_of("1", "joint");
  EXPECT_THAT(to_terminal(make_table2(std::vector{e})), Not(HasSubstr("RMSE_H")));
  e.lines[0].displacement = RidgeDisplacement{.horizontal_m = 0.25, .vertical_m = -0.5};
  const std::string text = to_terminal(make_table2(std::vector{with_summaries(e)}));
  EXPECT_THAT(text, HasSubstr("ridges  RMSE_H  RMSE_V\n"));
  EXPECT_THAT(text, HasSubstr("     1   0.250   0.500\n"));
}

TEST(TerminalTable, SaysHowFewLinesMakeTheHeadline) {
  Evaluation e = evaluation_of("1", "joint");
  e.lines[0] = evaluated_line("0", 4.0, 1);
  e.lines[1] = evaluated_line("1", 2.0, 2);
  e.lines[1].decided_by = DecidedBy::kPlace;
  const std::string text = to_terminal(make_table2(std::vector{with_summaries(e)}));
  EXPECT_THAT(text, ContainsRegex("total plan_images  +11  +12  1\\.210"));
  EXPECT_THAT(text, ContainsRegex("total points_place  +1  +12  2\\.000"));
  EXPECT_THAT(text, ContainsRegex("total all  +12  +12  1\\.294"));
  EXPECT_THAT(text,
              HasSubstr("\n1, joint: 1 of 11 lines contribute half of the sum of squares; RMS of "
                        "the others 0.100 m.\n"));
}

TEST(TerminalTable, OfMatchesIsEmptyWithoutRows) {
  EXPECT_EQ(to_terminal(Table1{}), "");
  Table1 table;
  table.rows = {{"1", "pairwise", {90, 10, 10}}};
  EXPECT_THAT(to_terminal(table),
              HasSubstr("1      pairwise       90     10      10           90.0"));
}

}  // namespace
}  // namespace ridgeline::evaluate
