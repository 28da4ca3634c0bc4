// SPDX-License-Identifier: BSD-3-Clause
// What to fix first: to_fix.csv and the layer of the map.
#include "io/files/csv_table.h"
#include "io/lines/read_lines.h"
#include "tests/cli/cli_fixture.h"

#include <fmt/format.h>

#include <string>

namespace ridgeline::cli {
namespace {

using ::testing::HasSubstr;

/// True lines of the scene as a table, one of them moved.
class ToFix : public Cli {
 protected:
  static constexpr double kRaised_m = 0.6;

  /// @return the number of the line that was raised: the longest ridge
  std::size_t write_lines_with_one_raised() const {
    const io::LineSet truth = io::read_lines(path("scene/truth.geojson").string());
    std::size_t raised = 0;
    double longest_m = 0.0;
    for (std::size_t i = 0; i < truth.lines.size(); ++i) {
      const double length_m = length(truth.lines[i].segment_in_world);
      if (truth.lines[i].kind != "ridge" || length_m <= longest_m) continue;
      raised = i;
      longest_m = length_m;
    }
    std::string text = "Nr,Haus,x1,y1,z1,x2,y2,z2\n";
    for (std::size_t i = 0; i < truth.lines.size(); ++i) {
      const Segment3& s = truth.lines[i].segment_in_world;
      const double by_m = i == raised ? kRaised_m : 0.0;
      text += fmt::format("L{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}\n", i,
                          truth.lines[i].building, s.start.x(), s.start.y(), s.start.z() + by_m,
                          s.end.x(), s.end.y(), s.end.z() + by_m);
    }
    write(path("lines.csv"), text);
    return raised;
  }
};

TEST_F(ToFix, NamesTheWrongLineByTheUsersIdAndSaysHowFarToMoveIt) {
  const std::size_t raised = write_lines_with_one_raised();
  const ProgramResult result = evaluate(
      "lines.csv", "out", {"--no-report", "--id", "nr", "--building", "Haus", "--decoys", "0"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const io::CsvTable table(path("out/to_fix.csv").string());
  ASSERT_EQ(table.size(), 1U);
  const auto text = [&](const char* column) {
    return std::string(table.text(0, table.column(column)));
  };
  EXPECT_EQ(text("rank"), "1");
  EXPECT_EQ(text("what"), "line");
  EXPECT_EQ(text("id"), fmt::format("L{}", raised));
  EXPECT_NE(text("building"), "");
  EXPECT_EQ(text("kind"), "ridge");
  EXPECT_GT(table.number(0, table.column("gain_share")), 0.9);
  EXPECT_NEAR(table.number(0, table.column("move_z_m")), -kRaised_m, 0.1);
}

TEST_F(ToFix, IsEmptyForRightLines) {
  ASSERT_EQ(evaluate("scene/truth.geojson", "out", {"--no-report"}).exit_code, 0);
  EXPECT_EQ(io::CsvTable(path("out/to_fix.csv").string()).size(), 0U);
}

TEST_F(ToFix, ColumnsThatTheFileLacksAreRefused) {
  EXPECT_REFUSED(evaluate("scene/truth.geojson", "out", {"--id", "nr"}),
                 HasSubstr("truth.geojson: has no column nr; it has class"));
}

}  // namespace
}  // namespace ridgeline::cli
