// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"
#include "tests/support/paths.h"

#include <iterator>
#include <sstream>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;

class Demo : public Cli {};

TEST_F(Demo, RunsTheSamplePatchesOfTheSourceTreeAndPrintsBothTables) {
  const ProgramResult result = run({"demo", "--out", "demo"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(names_in(path("demo")),
              IsSupersetOf({"1", "2", "3", "4", "5", "run.json", "table1.csv", "table1.md",
                            "table2.csv", "table2.json", "table2.md", "table2.tex"}));
  EXPECT_THAT(result.out, HasSubstr("patch  matcher   correct  false  missed"));
  EXPECT_THAT(result.out, HasSubstr("patch  method  class                     judged  lines"));
  EXPECT_THAT(result.out, HasSubstr("demo/2/judged.lines.gpkg\n"));
  const std::string table = read(path("demo/table2.csv"));
  for (const char* row :
       {"1,direct,aligned,", "2,joint,total,", "3,joint,not_aligned,", "4,lines,total,"}) {
    EXPECT_THAT(table, HasSubstr(row));
  }
  EXPECT_THAT(result.out, HasSubstr("Tracks, by true edges"));
  EXPECT_THAT(read(path("demo/4/accuracy.joint.md")), HasSubstr("| n_images"));
  const nlohmann::json edges = read_json(path("demo/run.json"))["edges"];
  EXPECT_EQ(edges["1"]["left"]["scales"][0]["scale_px"], 1);
  EXPECT_EQ(edges["5"]["left"]["scales"][0]["scale_px"], 2);  // a soft pair
}

/// The words of the commands of sample_data/make.sh that begin with `make`.
std::vector<std::vector<std::string>> commands_of_samples() {
  std::vector<std::vector<std::string>> commands;
  std::istringstream script(read(fs::path(test::source_dir()) / "sample_data/make.sh"));
  for (std::string row; std::getline(script, row);) {
    if (!row.starts_with("make ")) continue;
    std::istringstream words(row.substr(5));
    commands.emplace_back(std::istream_iterator<std::string>(words),
                          std::istream_iterator<std::string>());
  }
  return commands;
}

// Images take minutes with sanitizers, and what a view shows is known with the images alone.
TEST_F(Demo, SampleDataIsThatOfTheScriptThatMakesIt) {
  const auto commands = commands_of_samples();
  EXPECT_EQ(commands.size(), 5U);
  for (const std::vector<std::string>& command : commands) {
    std::vector<std::string> words{"simulate", "--no-images", "--out"};
    words.insert(words.end(), command.begin(), command.end());
    ASSERT_EQ(run(words).exit_code, 0) << command[0];
    for (const char* file :
         {"lidar.las", "lines.good.geojson", "lines.fair.geojson", "lines.poor.geojson"}) {
      EXPECT_TRUE(read(path(command[0]) / file) ==
                  read(fs::path(test::source_dir()) / "sample_data" / command[0] / file))
          << command[0] << '/' << file;
    }
  }
}

TEST_F(Demo, SampleDataThatLacksAFileIsNamed) {
  std::filesystem::create_directories(path("samples"));
  std::filesystem::copy(path("scene"), path("samples/a"));
  EXPECT_REFUSED(
      run({"demo", "--out", "demo"}, {"RIDGELINE_SAMPLE_DATA=" + path("samples").string()}),
      HasSubstr("patch.yaml"));
}

}  // namespace
}  // namespace ridgeline::cli
