// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"

namespace ridgeline::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;

class Demo : public Cli {};

TEST_F(Demo, JudgesTheSampleDataOfTheSourceTree) {
  const std::filesystem::path samples = std::filesystem::path(RIDGELINE_SOURCE_DIR) / "sample_data";
  if (!std::filesystem::exists(samples / "1/lidar.las")) GTEST_SKIP() << samples << " is empty";
  const ProgramResult result = run({"demo", "--out", "demo"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(names_in(path("demo")), IsSupersetOf({"1", "2", "3", "run.json", "table2.csv",
                                                    "table2.json", "table2.md", "table2.tex"}));
  EXPECT_THAT(result.out, HasSubstr(read(path("demo/table2.md"))));
}

TEST_F(Demo, JudgesEachGradeOfEachPatchOfAGivenFolder) {
  for (const char* patch : {"a", "b"}) {
    std::filesystem::create_directories(path("samples"));
    std::filesystem::copy(path("scene"), path("samples") / patch);
  }
  const ProgramResult result =
      run({"demo", "--out", "demo"}, {"RIDGELINE_SAMPLE_DATA=" + path("samples").string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string table = read(path("demo/table2.csv"));
  for (const char* row : {"a,good,total,", "a,fair,total,", "b,poor,total,"}) {
    EXPECT_THAT(table, HasSubstr(row));
  }
  EXPECT_THAT(
      names_in(path("demo/b")),
      IsSupersetOf({"evaluation.good.json", "evaluation.fair.json", "evaluation.poor.json"}));
}

TEST_F(Demo, SampleDataThatLacksAFileIsNamed) {
  std::filesystem::create_directories(path("samples"));
  std::filesystem::copy(path("scene"), path("samples/a"));
  std::filesystem::remove(path("samples/a/lines.fair.geojson"));
  EXPECT_REFUSED(
      run({"demo", "--out", "demo"}, {"RIDGELINE_SAMPLE_DATA=" + path("samples").string()}),
      HasSubstr("lines.fair.geojson"));
}

}  // namespace
}  // namespace ridgeline::cli
