// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class SimulateModels : public Cli {
 protected:
  [[nodiscard]] ProgramResult simulate(const std::string& out,
                                       const std::vector<std::string>& more) const {
    std::vector<std::string> words{"simulate", "--out", out, "--extent-m", "60,60", "--no-images"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
};

TEST_F(SimulateModels, AreWrittenBesideTheOtherFilesWhichKeepTheirBytes) {
  ASSERT_EQ(simulate("plain", {}).exit_code, 0);
  ASSERT_EQ(simulate("models", {"--models", "citygml,cityjson"}).exit_code, 0);
  for (const std::string& name : names_in(path("plain"))) {
    if (name == "simulate.json") continue;
    EXPECT_TRUE(read(path("plain") / name) == read(path("models") / name)) << name;
  }
  EXPECT_EQ(names_in(path("models")).size(), names_in(path("plain")).size() + 2);
  EXPECT_THAT(read(path("models/simulate.json")),
              AllOf(HasSubstr("buildings.city.json"), HasSubstr("buildings.gml")));
  EXPECT_THAT(read(path("plain/simulate.json")), Not(HasSubstr("buildings.")));
}

TEST_F(SimulateModels, HaveTheBuildingsOfTheTruth) {
  ASSERT_EQ(simulate("s", {"--models", "cityjson"}).exit_code, 0);
  const nlohmann::json city = read_json(path("s/buildings.city.json"));
  EXPECT_EQ(city["metadata"]["referenceSystem"], "https://www.opengis.net/def/crs/EPSG/0/25832");
  const nlohmann::json truth = read_json(path("s/truth.geojson"));
  std::size_t num_lines = 0;
  for (const nlohmann::json& line : truth["features"]) {
    if (!line["properties"].contains("building")) continue;
    ++num_lines;
    const std::string id = "building_" + line["properties"]["building"].get<std::string>();
    ASSERT_TRUE(city["CityObjects"].contains(id)) << id;
    EXPECT_EQ(city["CityObjects"][id]["geometry"][0]["lod"], "2");
  }
  EXPECT_GT(num_lines, 0U);
}

TEST_F(SimulateModels, OfAnotherFormatAreRefused) {
  EXPECT_REFUSED(simulate("s", {"--models", "obj"}),
                 AllOf(HasSubstr("--models"), HasSubstr("obj")));
}

}  // namespace
}  // namespace ridgeline::cli
