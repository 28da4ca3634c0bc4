// SPDX-License-Identifier: BSD-3-Clause
// What becomes of files and streams that results are written to.
#include "tests/cli/cli_fixture.h"
#include "tests/support/paths.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <map>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kGoodLines = "scene/lines.good.geojson";

class Outputs : public Cli {
 protected:
  /// Runs the program by a shell that opens its streams.
  [[nodiscard]] ProgramResult shell(const std::string& command) const {
    return test::run_program("/bin/sh", {"-c", command}, path(""));
  }
};

TEST_F(Outputs, FullStandardOutputIsAnErrorOfEveryKindOfAnswer) {
  for (const char* command : {"--help", "--version", "info scene/lidar.las", "evaluate --help"}) {
    EXPECT_REFUSED(shell(test::program() + " " + command + " > /dev/full"),
                   HasSubstr("standard output"));
    EXPECT_REFUSED(shell(test::program() + " " + command + " >&-"), HasSubstr("standard output"));
  }
}

TEST_F(Outputs, ReaderThatHasSeenEnoughIsNoFault) {
  const ProgramResult result =
      shell("(" + test::program() + " --help; echo $? > code) | true; cat code");
  EXPECT_EQ(result.out, "0\n");
  EXPECT_EQ(result.err, "");
}

TEST_F(Outputs, QuietPrintsErrorsOnly) {
  const ProgramResult good = evaluate(kGoodLines, "out", {"--quiet"});
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_EQ(good.out + good.err, "");
  EXPECT_REFUSED(evaluate("none.geojson", "out", {"--quiet"}), HasSubstr("none.geojson"));
  EXPECT_NE(run({"info", kGoodLines, "--quiet"}).out, "");
}

TEST_F(Outputs, FailedCommandsLeaveNoFolders) {
  EXPECT_REFUSED(evaluate("none.geojson", "new/deep"), HasSubstr("none.geojson"));
  EXPECT_REFUSED(
      run({"evaluate", "--lines", kGoodLines, "--cloud", "scene/truth.geojson", "--out", "new"}),
      HasSubstr("truth.geojson"));
  EXPECT_FALSE(fs::exists(path("new")));
}

TEST_F(Outputs, FolderThatAnotherRunWritesToIsRefusedUntilItsEnd) {
  fs::create_directory(path("out"));
  write(path("out/.ridgeline.lock"), "process 7 on elsewhere");
  const int lock = open(path("out/.ridgeline.lock").c_str(), O_RDWR);
  ASSERT_EQ(flock(lock, LOCK_EX), 0);
  EXPECT_REFUSED(evaluate(kGoodLines, "out"), AllOf(HasSubstr("out: process 7 on elsewhere"),
                                                    HasSubstr("choose another folder")));
  close(lock);  // as the kernel does for a process that was killed
  EXPECT_EQ(evaluate(kGoodLines, "out", {"--no-report"}).exit_code, 0);
  EXPECT_THAT(names_in(path("out")), Not(testing::Contains(".ridgeline.lock")));
}

TEST_F(Outputs, FilesThatAKilledRunLeftAreRemovedByTheNext) {
  // above the largest process number of Linux, 2^22
  write(path("out/.table2.4194305.3.tmp.csv"), "half");
  write(path("out/.mine.csv"), "mine");
  ASSERT_EQ(evaluate(kGoodLines, "out", {"--no-report"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("out/.table2.4194305.3.tmp.csv")));
  EXPECT_TRUE(fs::exists(path("out/.mine.csv")));
}

TEST_F(Outputs, NamesThatAreNoUtf8AreTaken) {
  const std::string odd = "odd\xff";
  fs::copy(path(kGoodLines), path(odd + ".geojson"));
  fs::copy(path("scene/lidar.las"), path(odd + ".las"));
  const ProgramResult judged =
      run({"evaluate", "--lines", odd + ".geojson", "--cloud", odd + ".las", "--out", odd});
  EXPECT_EQ(judged.exit_code, 0) << judged.err;
  EXPECT_TRUE(fs::exists(path(odd + "/run.json")));
  EXPECT_EQ(run({"info", odd + ".las"}).exit_code, 0);
  EXPECT_EQ(run({"report", odd}).exit_code, 0);
  EXPECT_EQ(run({"compare", odd, odd}).exit_code, 0);
  write(path("gates.yaml"), "gates: [{metric: rms_m, class: total, max: 10}]\n");
  EXPECT_EQ(run({"gate", odd, "--gates", "gates.yaml", "--json", odd + ".json"}).exit_code, 0);
}

TEST_F(Outputs, SimulateWritesOverItsOwnFilesAlone) {
  const auto simulate = [&] {
    return run(
        {"simulate", "--out", "village", "--seed", "4", "--extent-m", "40,40", "--no-images"});
  };
  ASSERT_EQ(simulate().exit_code, 0);
  EXPECT_EQ(simulate().exit_code, 0);
  write(path("village/truth.geojson"), "edited");
  EXPECT_REFUSED(simulate(), AllOf(HasSubstr("village/truth.geojson"), HasSubstr("overwritten")));
  EXPECT_EQ(read(path("village/truth.geojson")), "edited");
  fs::remove(path("village/simulate.json"));
  fs::remove(path("village/truth.geojson"));
  EXPECT_REFUSED(simulate(), HasSubstr("village/lidar.las"));
}

/// Copies of the small patch under other ids.
class PatchIds : public SmallPatch {
 protected:
  [[nodiscard]] ProgramResult run_with_id(const std::string& id) const {
    std::string text = read(path("patch/patch.yaml"));
    write(path("patch/other.yaml"), "id: " + id + text.substr(text.find('\n')));
    return run({"run", "patch/other.yaml", "--out", "out"});
  }
};

TEST_F(PatchIds, ThatNameNoFolderOfTheirOwnAreRefusedBeforeTheWork) {
  for (const char* id :
       {"table1.csv", "Table2.md", "report.html", "run.json", "\"con\\0x\"", "\" a\"", "\"a \"",
        "\"\"", "..", ".a", "a/b", "\"a\\nb\"", "\"a\\\\b\""}) {
    EXPECT_REFUSED(run_with_id(id), AllOf(HasSubstr("other.yaml"), HasSubstr("id ")));
    EXPECT_FALSE(fs::exists(path("out"))) << id;
  }
  EXPECT_REFUSED(run_with_id(std::string(101, 'a')), HasSubstr("100 bytes"));
}

TEST_F(PatchIds, ThatDifferInCaseAloneAreRefused) {
  const std::string text = read(path("patch/patch.yaml"));
  for (const char* id : {"a", "A"}) {
    write(path(std::string("patch/") + id + ".yaml"),
          std::string("id: ") + id + text.substr(text.find('\n')));
  }
  EXPECT_REFUSED(run({"run", "patch/a.yaml", "patch/A.yaml", "--out", "out"}),
                 AllOf(HasSubstr("A.yaml"), HasSubstr("ignoring case")));
}

}  // namespace
}  // namespace ridgeline::cli
