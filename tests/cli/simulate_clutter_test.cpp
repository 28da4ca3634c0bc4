// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace ridgeline::cli {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

class SimulateClutter : public Cli {
 protected:
  [[nodiscard]] ProgramResult simulate(const std::string& out,
                                       const std::vector<std::string>& more) const {
    std::vector<std::string> words{"simulate", "--out", out, "--extent-m", "60,60", "--no-images"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  [[nodiscard]] std::set<std::string> kinds_in(const std::string& folder) const {
    std::set<std::string> kinds;
    const nlohmann::json truth = read_json(path(folder) / "truth.geojson");
    for (const nlohmann::json& line : truth["features"]) {
      const nlohmann::json& properties = line["properties"];
      kinds.insert(properties["kind"].get<std::string>());
      EXPECT_EQ(properties.contains("plane_ids"), properties["kind"] != "object");
    }
    return kinds;
  }
};

TEST_F(SimulateClutter, AddsKindsOfLinesAndTheirSurfaces) {
  ASSERT_EQ(simulate("s", {"--clutter"}).exit_code, 0);
  const std::set<std::string> kinds = kinds_in("s");
  for (const char* kind : {"foot", "wall_top", "object"}) EXPECT_THAT(kinds, Contains(kind));
}

TEST_F(SimulateClutter, TakesEachOptionBeforeItsDefaultInAnyOrder) {
  ASSERT_EQ(simulate("a", {"--clutter", "--no-foot-lines", "--garden-wall-share", "0"}).exit_code,
            0);
  ASSERT_EQ(simulate("b", {"--no-foot-lines", "--garden-wall-share", "0", "--clutter"}).exit_code,
            0);
  for (const char* folder : {"a", "b"}) {
    const std::set<std::string> kinds = kinds_in(folder);
    EXPECT_THAT(kinds, Contains("object"));
    EXPECT_THAT(kinds, Not(Contains("foot")));
    EXPECT_THAT(kinds, Not(Contains("wall_top")));
  }
  EXPECT_TRUE(read(path("a/truth.geojson")) == read(path("b/truth.geojson")));
}

TEST_F(SimulateClutter, OfImpossibleAmountIsRefused) {
  EXPECT_REFUSED(simulate("s", {"--cars-per-lot", "9"}), HasSubstr("cars_per_lot"));
}

}  // namespace
}  // namespace ridgeline::cli
