// SPDX-License-Identifier: BSD-3-Clause
// A patch whose cameras come from a table of orientations, in every command that takes patches.
#include "tests/cli/oriented_patch.h"

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::size_t n_found(std::string_view text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

TEST_F(OrientedPatch, GivesTheLinesOfThePatchWithMatrices) {
  ASSERT_EQ(run_oriented().exit_code, 0);
  const ProgramResult typed =
      run({"run", "patch/patch.yaml", "--out", "typed", "--methods", "direct", "--no-report"});
  ASSERT_EQ(typed.exit_code, 0) << typed.err;
  const auto n_lines = [&](const char* folder) {
    return read_json(path(std::string(folder) + "/1/lines.direct.geojson"))["features"].size();
  };
  EXPECT_GT(n_lines("out"), 5U);
  EXPECT_EQ(n_lines("out"), n_lines("typed"));
  EXPECT_EQ(n_inputs("out", "orientation"), 2);
  EXPECT_EQ(n_inputs("typed", "orientation"), 0);
  const ProgramResult compared = run({"compare", "out", "typed"});
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
}

TEST_F(OrientedPatch, IsMatchedAnewIfThePosesHaveChanged) {
  ASSERT_EQ(run_oriented().exit_code, 0);
  EXPECT_THAT(run_oriented({"--resume"}).err, HasSubstr("6 finished stages skipped"));
  write_orientation("omega_deg,phi_deg,kappa_deg", 0.25);
  const ProgramResult raised = run_oriented({"--resume"});
  EXPECT_EQ(raised.exit_code, 0) << raised.err;
  EXPECT_THAT(raised.err, HasSubstr("1 finished stages skipped"));  // the segments
}

TEST_F(OrientedPatch, IsNotReportedOnIfTheTableHasChanged) {
  ASSERT_EQ(run_oriented().exit_code, 0);
  EXPECT_THAT(run({"report", "out"}).err, Not(HasSubstr("opk.csv")));
  write(path("patch/opk.csv"), read(path("patch/opk.csv")) + "further,1,2,3,0,0,0,of_left\n");
  EXPECT_THAT(run({"report", "out"}).err, HasSubstr("opk.csv: has changed since the run"));
}

TEST_F(OrientedPatch, ServesEveryCommandThatTakesPatches) {
  const ProgramResult info = run({"info", "patch/oriented.yaml"});
  EXPECT_THAT(info.out, AllOf(HasSubstr("orientation patch/opk.csv patch/cameras.yaml"),
                              HasSubstr("image       left: patch/left.tif")));
  EXPECT_EQ(run({"match", "patch/oriented.yaml", "--out", "matches.csv"}).exit_code, 0);
  EXPECT_EQ(run({"reconstruct", "patch/oriented.yaml", "--matches", "matches.csv", "--method",
                 "direct", "--out", "lines.geojson"})
                .exit_code,
            0);
  EXPECT_EQ(run({"extract", "patch/left.tif", "--patch", "patch/oriented.yaml", "--out", "e.csv"})
                .exit_code,
            0);
  const ProgramResult judged = run({"evaluate", "--lines", "lines.geojson", "--patch",
                                    "patch/oriented.yaml", "--out", "judged", "--no-report"});
  EXPECT_EQ(judged.exit_code, 0) << judged.err;
  EXPECT_EQ(n_inputs("judged", "orientation"), 2);
  EXPECT_REFUSED(run({"match", "patch/oriented.yaml", "--out", "patch/opk.csv", "--quiet"}),
                 HasSubstr("patch/opk.csv"));
}

TEST_F(OrientedPatch, SaysOnceWhatItsImagesDecide) {
  write_orientation("omega,phi,kappa", 0.0);
  const ProgramResult info = run({"info", "patch/oriented.yaml"});
  EXPECT_THAT(info.out, HasSubstr("decided     patch/opk.csv: The file does not define"));
  const ProgramResult result = run_oriented();
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("info: patch/opk.csv: "));
  EXPECT_EQ(n_found(result.err, "Determined: "), 1U) << result.err;
  EXPECT_EQ(n_found(read(path("out/run.json")), "Determined: "), 1U);
}

TEST_F(OrientedPatch, NamesTheTableThatIsDamaged) {
  write(path("patch/opk.csv"), "name,x,y,z,omega_deg,phi_deg,kappa_deg\nleft,1,2\n");
  EXPECT_REFUSED(run_oriented(), HasSubstr("patch/opk.csv:2: "));
  write(path("patch/opk.csv"),
        "name,x,y,z,omega_deg,phi_deg,kappa_deg,camera\nleft,513000,5403000,1500,0,0,0,of_left\n");
  EXPECT_REFUSED(run_oriented(),
                 AllOf(HasSubstr("patch/oriented.yaml: line "),
                       HasSubstr("patch/opk.csv has no image right.tif; similar names")));
}

}  // namespace
}  // namespace ridgeline::cli
