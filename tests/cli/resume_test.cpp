// SPDX-License-Identifier: BSD-3-Clause
// Runs that are killed, and two runs into one folder.
#include "tests/cli/cli_fixture.h"
#include "tests/support/paths.h"

#include <map>
#include <utility>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr int kKilled = 128 + 9;

/// Its patch is as small as can be, because it is run twenty times.
class Resume : public Cli {
 protected:
  void SetUp() override {
    const ProgramResult made =
        run({"simulate", "--out", "patch", "--seed", "3", "--extent-m", "40,40",
             "--samples-per-side", "1", "--focal-length-px", "7000"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }

  /// A shell's script with the program and the arguments of a run as $@, and `file` as $0.
  [[nodiscard]] ProgramResult script(const std::string& script,
                                     const std::string& file,
                                     const std::vector<std::string>& more) const {
    std::vector<std::string> words{
        "-c",    script, file,        test::program(), "run",    "patch/patch.yaml",
        "--out", "out",  "--methods", "direct,joint",  "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return test::run_program("/bin/bash", words, path("."));
  }

  /// Kills a run as soon as `file` stands there.
  [[nodiscard]] ProgramResult killed_run(const std::string& file,
                                         const std::vector<std::string>& more) const {
    return script(
        "\"$@\" & until [ -e \"$0\" ] || ! kill -0 $!; do sleep 0.002; done; "
        "kill -KILL $!; wait $!",
        file, more);
  }

  [[nodiscard]] ProgramResult resume(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"run",       "patch/patch.yaml", "--out",   "out",
                                   "--methods", "direct,joint",     "--resume"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
};

TEST_F(Resume, AfterAKillGivesTheBytesOfAnUndisturbedRun) {
  ASSERT_EQ(resume({}).exit_code, 0);
  const auto undisturbed = results_in("out");
  for (const auto& [file, jobs] :
       {std::pair("out/patch/segments.left.csv", "1"), std::pair("out/patch/surface.las", "2"),
        std::pair("out/patch/matches.csv", "2"), std::pair("out/patch/lines.direct.geojson", "1"),
        std::pair("out/patch/evaluation.direct.json", "2"), std::pair("out/table2.json", "1"),
        std::pair("out/run.json", "2")}) {
    SCOPED_TRACE(std::string(file) + ", threads: " + jobs);
    fs::remove_all(path("out"));
    EXPECT_EQ(killed_run(file, {"--jobs", jobs}).exit_code, kKilled);
    const ProgramResult result = resume({"--jobs", jobs});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(results_in("out"), undisturbed);
  }
}

TEST_F(Resume, AfterSeveralKillsGivesTheBytesOfAnUndisturbedRun) {
  ASSERT_EQ(resume({}).exit_code, 0);
  const auto undisturbed = results_in("out");
  fs::remove_all(path("out"));
  for (const char* file : {"out/patch/segments.right.csv", "out/patch/unmatched.csv",
                           "out/patch/lines.joint.geojson", "out/table1.md"}) {
    EXPECT_EQ(killed_run(file, {"--resume"}).exit_code, kKilled) << file;
  }
  EXPECT_EQ(resume({}).exit_code, 0);
  EXPECT_EQ(results_in("out"), undisturbed);
}

TEST_F(Resume, ASecondRunIntoAFolderInUseIsRefused) {
  const ProgramResult second = script(
      "\"$@\" & until [ -s \"$0\" ] || ! kill -0 $!; do sleep 0.002; done; kill -STOP $!; "
      "\"$@\"; code=$?; kill -CONT $!; wait $! || exit 99; exit $code",
      "out/.ridgeline.lock", {});
  EXPECT_REFUSED(second, AllOf(HasSubstr("out"), HasSubstr("process "),
                               HasSubstr("is writing results there")));
  EXPECT_FALSE(fs::exists(path("out/.ridgeline.lock")));
  EXPECT_TRUE(fs::exists(path("out/run.json")));
}

}  // namespace
}  // namespace ridgeline::cli
