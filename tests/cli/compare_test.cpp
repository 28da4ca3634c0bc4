// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Compare : public Cli {
 protected:
  /// Judges the lines of a grade, all grades under one method name: "lines".
  void judge(const std::string& grade) const {
    const std::filesystem::path lines = path(grade + "/lines.geojson");
    std::filesystem::create_directories(lines.parent_path());
    std::filesystem::copy(path("scene/lines." + grade + ".geojson"), lines);
    const ProgramResult result = evaluate(grade + "/lines.geojson", grade + "/out");
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
};

TEST_F(Compare, PairsTheLinesOfTwoFoldersPlainInTheTerminalAndAsMarkdownInTheFile) {
  judge("good");
  judge("fair");
  const ProgramResult result = run({"compare", "fair/out", "good/out", "--out", "cmp"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("On the common lines"), HasSubstr("\ntotal  ")));
  EXPECT_THAT(result.out, AllOf(Not(HasSubstr("| ")), Not(HasSubstr("\\"))));
  EXPECT_THAT(read(path("cmp/compare.md")),
              AllOf(HasSubstr("On the common lines"), HasSubstr("| total |")));
  EXPECT_FALSE(read_json(path("cmp/compare.json")).is_discarded());
}

TEST_F(Compare, FailsIfAFigureIsWorseByMoreThanTheMargin) {
  judge("good");
  judge("poor");
  EXPECT_EQ(run({"compare", "poor/out", "good/out", "--fail-if-worse", "rms_m:0"}).exit_code, 0);
  const ProgramResult worse =
      run({"compare", "good/out", "poor/out", "--fail-if-worse", "rms_m:0.01", "--out", "cmp"});
  EXPECT_EQ(worse.exit_code, 3) << worse.err;
  EXPECT_THAT(worse.out, HasSubstr("Worse: patch lidar: rms_m by more than 0.01: "));
  EXPECT_TRUE(std::filesystem::exists(path("cmp/compare.md")));
  EXPECT_REFUSED(run({"compare", "good/out", "poor/out", "--fail-if-worse", "rms_m"}),
                 HasSubstr("must be METRIC:MARGIN"));
  EXPECT_REFUSED(run({"compare", "good/out", "poor/out", "--fail-if-worse", "rms:0"}),
                 HasSubstr("the metric must be one of rms_m, "));
}

TEST_F(Compare, OneFolderComparesItsMethods) {
  ASSERT_EQ(run({"evaluate", "--lines", "scene/lines.good.geojson", "scene/lines.fair.geojson",
                 "--cloud", "scene/lidar.las", "--out", "both"})
                .exit_code,
            0);
  const ProgramResult result = run({"compare", "both"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("lines.good"), HasSubstr("lines.fair")));
}

TEST_F(Compare, RefusesWhatCannotBeCompared) {
  judge("good");
  EXPECT_REFUSED(run({"compare", "good/out"}),
                 AllOf(HasSubstr("good/out"), HasSubstr("give a second folder")));
  EXPECT_REFUSED(run({"compare", "none"}), HasSubstr("none: is not a results folder"));
  EXPECT_REFUSED(run({"compare", "good/out", "scene"}), HasSubstr("scene: holds no evaluation"));
  EXPECT_REFUSED(run({"compare"}), HasSubstr("folders is required"));
}

}  // namespace
}  // namespace ridgeline::cli
