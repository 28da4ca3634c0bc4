// SPDX-License-Identifier: BSD-3-Clause
// The files of earlier versions, which are never edited; see tests/compatibility.
#include "tests/cli/cli_fixture.h"
#include "tests/support/paths.h"

namespace ridgeline::cli {
namespace {

using ::testing::HasSubstr;

class FilesOf02 : public SmallPatch {
 protected:
  static std::string file(const std::string& name) {
    return test::source_dir() + "/tests/compatibility/0.2/" + name;
  }
};

TEST_F(FilesOf02, ParametersAndGatesMeanWhatTheyMeant) {
  ASSERT_EQ(run({"run", "patch/patch.yaml", "--out", "out", "--no-report", "--methods", "joint",
                 "--config", file("config.yaml")})
                .exit_code,
            0);
  const auto judge = read_json(path("out/run.json"))["options"]["judge"];
  EXPECT_EQ(judge["min_points"], 20);
  const ProgramResult held =
      run({"gate", "out", "--gates", file("gates.yaml"), "--baseline", "out"});
  EXPECT_EQ(held.exit_code, 0) << held.out << held.err;
  const ProgramResult failed = run({"gate", "out", "--gates", file("gates_that_fail.yaml")});
  EXPECT_EQ(failed.exit_code, 3) << failed.err;
  EXPECT_THAT(failed.out, HasSubstr("(0 of 12 checks passed)"));
}

}  // namespace
}  // namespace ridgeline::cli
