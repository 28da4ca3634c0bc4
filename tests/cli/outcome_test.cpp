// SPDX-License-Identifier: BSD-3-Clause
// Runs whose lines are not judged.
#include "tests/cli/cli_fixture.h"

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

class Outcome : public SmallPatch {
 protected:
  void remove_lidar() const {
    std::string text = read(path("patch/patch.yaml"));
    const std::size_t at = text.find("lidar:");
    text.erase(at, text.find("reference_matches") - at);
    write(path("patch/patch.yaml"), text);
  }

  /// Expects a single sentence in place of the table, at the top of the report and in run.json.
  void expect_message(const ProgramResult& result, const std::string& pattern) const {
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(result.out, ContainsRegex(pattern));
    EXPECT_THAT(read(path("out/report.html")), ContainsRegex(pattern));
    const auto messages = read_json(path("out/run.json"))["messages"];
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_THAT(messages[0].get<std::string>(), ContainsRegex("^" + pattern + "$"));
  }
};

TEST_F(Outcome, RunWithoutLidarSaysHowManyLinesThereAre) {
  remove_lidar();
  const ProgramResult result =
      run({"run", "patch/patch.yaml", "--methods", "direct", "--out", "out"});
  expect_message(result,
                 "Patch 1: no LIDAR given: [1-9][0-9]* lines reconstructed, none judged\\.");
  EXPECT_THAT(result.out, Not(HasSubstr("Distances of the lines")));
  EXPECT_THAT(read(path("out/table2.md")), HasSubstr("RMS of the lines"));
}

TEST_F(Outcome, JudgedLinesNeedNoSentence) {
  const ProgramResult result =
      run({"run", "patch/patch.yaml", "--methods", "direct", "--out", "out", "--no-report"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("Distances of the lines"), Not(HasSubstr("Patch 1:"))));
  EXPECT_TRUE(read_json(path("out/run.json"))["messages"].empty());
}

TEST_F(Outcome, EvaluateSaysWhyNoLineWasJudged) {
  write(path("short.csv"),
        "id,x1,y1,z1,x2,y2,z2\n"
        "a,513010,5403010,250,513010.1,5403010,250\n"
        "b,513015,5403015,250,513015.1,5403015,250\n");
  const ProgramResult result =
      run({"evaluate", "--lines", "short.csv", "--cloud", "patch/lidar.las", "--out", "out"});
  expect_message(result, "Patch lidar: none of 2 lines could be judged: 2 too_short\\.");
  EXPECT_THAT(result.out, Not(HasSubstr("Distances of the lines")));
}

}  // namespace
}  // namespace ridgeline::cli
