// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"
#include "tests/support/paths.h"

#include <algorithm>
#include <cctype>
#include <regex>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class Usage : public Cli {};

TEST_F(Usage, HelpFitsOneScreenAndListsEverySubcommand) {
  const ProgramResult result = run({"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, IsEmpty());
  constexpr auto kScreenLines = 24;
  EXPECT_LE(std::count(result.out.begin(), result.out.end(), '\n'), kScreenLines);
  for (const char* command :
       {"demo", "evaluate", "gate", "compare", "simulate", "info", "run", "extract", "match",
        "reconstruct", "report", "config", "patch", "edges"}) {
    EXPECT_THAT(result.out, HasSubstr(command));
  }
}

TEST_F(Usage, EverySubcommandHasHelp) {
  for (const char* command :
       {"demo", "evaluate", "gate", "compare", "simulate", "info", "run", "extract", "match",
        "reconstruct", "report", "config", "patch", "edges"}) {
    const ProgramResult result = run({command, "--help"});
    EXPECT_EQ(result.exit_code, 0) << command;
    EXPECT_THAT(result.out, HasSubstr("--help")) << command;
    EXPECT_THAT(result.err, IsEmpty()) << command;
  }
}

TEST_F(Usage, EvaluateHelpNamesTheDefaultsInPlainText) {
  const std::string help = run({"evaluate", "--help"}).out;
  EXPECT_THAT(help, AllOf(HasSubstr("--gross-m FLOAT=1"), HasSubstr("=2000"),
                          HasSubstr("{plain,fkb}=plain"), HasSubstr("Examples:\n")));
  EXPECT_TRUE(std::none_of(help.begin(), help.end(),
                           [](unsigned char c) { return std::iscntrl(c) != 0 && c != '\n'; }));
}

TEST_F(Usage, VersionNamesProgramHashAndLibraries) {
  const ProgramResult result = run({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(std::regex_search(result.out, std::regex(R"(^ridgeline \d+\.\d+\.\d+ \(\w+\))")))
      << result.out;
  for (const char* library : {"pcl ", "eigen ", "tbb ", "gdal ", "proj "}) {
    EXPECT_THAT(result.out, HasSubstr(library));
  }
}

TEST_F(Usage, WrongUsageNamesTheWrongWord) {
  EXPECT_REFUSED(run({}), HasSubstr("subcommand is required"));
  EXPECT_REFUSED(run({"evalute"}),
                 HasSubstr("evalute, did you mean evaluate? (see ridgeline --help)"));
  EXPECT_REFUSED(run({"evaluate", "--line", "a.csv"}),
                 HasSubstr("--line a.csv, did you mean --lines? (see ridgeline evaluate --help)"));
  EXPECT_REFUSED(run({"evaluate", "--cloud", "a.las", "--out", "r"}), HasSubstr("--lines"));
  EXPECT_REFUSED(run({"info"}), HasSubstr("files is required"));
  EXPECT_REFUSED(run({"--log-level", "loud", "info", "scene/lidar.las"}), HasSubstr("loud"));
  EXPECT_REFUSED(run({"--jobs", "-1", "info", "scene/lidar.las"}), HasSubstr("-1"));
}

TEST_F(Usage, SimulateRefusesWhatCannotBeASceneWithTheRule) {
  const auto simulate = [&](const std::string& option, const std::string& value) {
    return run({"simulate", "--out", "s", option, value});
  };
  EXPECT_REFUSED(simulate("--extent-m", "0,0"), HasSubstr("[40, 2000]"));
  EXPECT_REFUSED(simulate("--extent-m", "60"), HasSubstr("--extent-m"));
  EXPECT_REFUSED(simulate("--density-per-m2", "0"), HasSubstr("density_per_m2 = 0"));
  EXPECT_REFUSED(simulate("--crs", "nonsense"), HasSubstr("\"nonsense\""));
  EXPECT_REFUSED(simulate("--crs", "EPSG:4326"), HasSubstr("WGS 84"));
  EXPECT_REFUSED(simulate("--origin-m", "0.5,0,0"), HasSubstr("must be integers"));
  EXPECT_REFUSED(simulate("--seed", "-1"), HasSubstr("--seed"));
  EXPECT_REFUSED(simulate("--bits", "12"), HasSubstr("--bits: 12 not in {8,16}"));
  std::filesystem::create_directories(path("s"));
  EXPECT_TRUE(std::filesystem::is_empty(path("s")));
}

TEST_F(Usage, SimulateWithOneSeedWritesTheSameBytes) {
  ASSERT_EQ(run({"simulate", "--out", "again", "--seed", "3", "--extent-m", "60,60", "--no-images"})
                .exit_code,
            0);
  for (const std::string& name : names_in(path("scene"))) {
    EXPECT_TRUE(read(path("scene") / name) == read(path("again") / name)) << name;
  }
}

TEST_F(Usage, ProgramNeedsNeitherVtkNorQt) {
  const ProgramResult result = test::run_program("/usr/bin/ldd", {test::program()}, path("."));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("libpcl_sample_consensus"));
  EXPECT_THAT(result.out, Not(HasSubstr("libvtk")));
  EXPECT_THAT(result.out, Not(HasSubstr("libQt")));
}

}  // namespace
}  // namespace ridgeline::cli
