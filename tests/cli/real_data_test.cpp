// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"

#include <algorithm>
#include <sstream>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr const char* kIgnTile = "test_data_77060_627760_LA93_IGN69";

class RealData : public Cli {};

#define SKIP_WITHOUT(folder) \
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << (folder) << " is absent"

TEST_F(RealData, InfoReadsOrRefusesEveryLasSampleByName) {
  const std::filesystem::path folder = shared_data("las_samples");
  SKIP_WITHOUT(folder);
  int n_read = 0;
  for (const std::string& name : names_in(folder)) {
    if (!name.ends_with(".las") && !name.ends_with(".laz")) continue;
    const ProgramResult result = run({"info", (folder / name).string()});
    if (result.exit_code == 0) {
      ++n_read;
      EXPECT_THAT(result.out, AllOf(HasSubstr(name), HasSubstr("points  "))) << name;
    } else {
      EXPECT_REFUSED(result, HasSubstr(name));
    }
  }
  EXPECT_GE(n_read, 20);  // the rest are damaged on purpose
}

TEST_F(RealData, LasAndLazOfATileHoldTheSame) {
  const std::filesystem::path folder = shared_data("ign");
  SKIP_WITHOUT(folder);
  const auto facts = [&](const std::string& extension) {
    const ProgramResult result = run({"info", (folder / (kIgnTile + extension)).string()});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out.substr(std::min(result.out.find("  points"), result.out.size()));
  };
  const std::string las = facts(".las");
  EXPECT_THAT(las, HasSubstr("classes"));
  EXPECT_EQ(las, facts(".laz"));
}

/// 4 m lines every 5 m over the tile, a storey above its lowest ground.
std::string lines_over_the_tile() {
  std::ostringstream rows;
  rows << "id,x1,y1,z1,x2,y2,z2\n";
  for (int x = 770605; x < 770650; x += 5) {
    for (int y = 6277555; y < 6277600; y += 5) {
      rows << x << '-' << y << ',' << x << ',' << y << ",25," << x + 4 << ',' << y << ",25\n";
    }
  }
  return rows.str();
}

TEST_F(RealData, EvaluateJudgesAlikeByLasAndLaz) {
  const std::filesystem::path folder = shared_data("ign");
  SKIP_WITHOUT(folder);
  write(path("lines.csv"), lines_over_the_tile());
  for (const char* extension : {"las", "laz"}) {
    const std::string cloud = (folder / (std::string(kIgnTile) + "." + extension)).string();
    const ProgramResult result = run({"evaluate", "--lines", "lines.csv", "--cloud", cloud,
                                      "--classes", "6", "--out", extension});
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  EXPECT_TRUE(read(path("las/evaluation.lines.json")) == read(path("laz/evaluation.lines.json")));
  const nlohmann::json total = read_json(path("las/evaluation.lines.json"))["summary"]["total"];
  EXPECT_EQ(total["n_lines"], 81);
  EXPECT_GT(total["n_evaluated"].get<int>(), 0);
}

}  // namespace
}  // namespace ridgeline::cli
