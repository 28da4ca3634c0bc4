// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"

namespace ridgeline::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::IsSupersetOf;

class Demo : public Cli {};

TEST_F(Demo, RunsTheSamplePatchesOfTheSourceTreeAndPrintsBothTables) {
  const ProgramResult result = run({"demo", "--out", "demo"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(names_in(path("demo")),
              IsSupersetOf({"1", "2", "3", "run.json", "table1.csv", "table1.md", "table2.csv",
                            "table2.json", "table2.md", "table2.tex"}));
  EXPECT_THAT(result.out, HasSubstr("patch  matcher   correct  false  missed"));
  EXPECT_THAT(result.out, HasSubstr("patch  method  class        judged  lines"));
  EXPECT_THAT(result.out, HasSubstr("demo/2/judged.joint.gpkg\n"));
  const std::string table = read(path("demo/table2.csv"));
  for (const char* row : {"1,direct,aligned,", "2,joint,total,", "3,joint,not_aligned,"}) {
    EXPECT_THAT(table, HasSubstr(row));
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
