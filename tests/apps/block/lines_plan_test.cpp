// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/lines_plan.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace ridgeline::apps {
namespace {

using ::testing::ElementsAre;

const LocalFrame kFrame{{1000.0, 2000.0, 0.0}};
constexpr double kSize_m = 100.0;

/// A line of 2 m to the north around a place in the world.
evaluate::JudgedLine line_at(double x, double y) {
  evaluate::JudgedLine line;
  const Eigen::Vector3d middle = kFrame.local_from_world({x, y, 5.0});
  const Eigen::Vector3d half(0.0, 1.0, 0.0);
  line.segment = {middle - half, middle + half};
  return line;
}

TEST(CellsOf, LieAtMultiplesOfTheirSizeAndHoldTheMiddles) {
  const results::LineSets lines{{line_at(1000.0, 2000.0), line_at(999.9, 2000.0)},
                                {line_at(1099.9, 2099.5), line_at(1050.0, 2100.0)}};
  const std::vector<LinesCell> cells = cells_of(lines, kFrame, kSize_m);
  EXPECT_THAT(cells, ElementsAre(LinesCell{9, 20, 1}, LinesCell{10, 20, 2}, LinesCell{10, 21, 1}));
  const auto numbers = numbers_by_cell(cells, lines, kFrame, kSize_m);
  EXPECT_THAT(numbers[0], ElementsAre(ElementsAre(1), ElementsAre()));
  EXPECT_THAT(numbers[1], ElementsAre(ElementsAre(0), ElementsAre(0)));
  EXPECT_THAT(numbers[2], ElementsAre(ElementsAre(), ElementsAre(1)));
}

TEST(CellsOf, LieAtMultiplesBelowZeroToo) {
  EXPECT_THAT(cells_of({{line_at(-0.5, -100.0), line_at(0.5, -100.5)}}, kFrame, kSize_m),
              ElementsAre(LinesCell{0, -2, 1}, LinesCell{-1, -1, 1}));
}

TEST(CellsOf, TakeLinesThatAreNowhereIntoTheFirst) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const results::LineSets lines{{line_at(nan, 2000.0), line_at(1350.0, 2000.0), line_at(1e300, 0.0),
                                 line_at(1450.0, 2000.0)}};
  const std::vector<LinesCell> cells = cells_of(lines, kFrame, kSize_m);
  EXPECT_THAT(cells, ElementsAre(LinesCell{13, 20, 3}, LinesCell{14, 20, 1}));
  EXPECT_THAT(numbers_by_cell(cells, lines, kFrame, kSize_m)[0], ElementsAre(ElementsAre(0, 1, 2)));
  EXPECT_THAT(cells_of({{line_at(nan, nan)}}, kFrame, kSize_m), ElementsAre(LinesCell{0, 0, 1}));
  EXPECT_TRUE(cells_of({{}, {}}, kFrame, kSize_m).empty());
}

TEST(NumbersByCell, RefusesCellsOfOtherLines) {
  const results::LineSets lines{{line_at(1000.0, 2000.0)}};
  const std::vector<LinesCell> cells = cells_of(lines, kFrame, kSize_m);
  EXPECT_THROW(numbers_by_cell(cells, {{line_at(1200.0, 2000.0)}}, kFrame, kSize_m),
               std::invalid_argument);
}

TEST(Difference, NamesWhatIsNotAsInThePlan) {
  const auto planned = nlohmann::ordered_json::parse(
      R"({"program":"1 a","block":"b","options":{"x":{"y":1}},"inputs":[
          {"role":"lines","path":"l","bytes":1,"modified_s":5,"sha256":"c"},
          {"role":"cloud","path":"t","bytes":2,"modified_s":6}]})");
  EXPECT_FALSE(difference(planned, planned));
  const auto changed = [&](const char* at, const nlohmann::ordered_json& value) {
    auto now = planned;
    now[nlohmann::ordered_json::json_pointer(at)] = value;
    const auto found = difference(planned, now);
    return found ? found->what + ": " + found->how : std::string();
  };
  EXPECT_EQ(changed("/program", "2 a"), R"(ridgeline 2 a: is not the version of the plan, "1 a")");
  EXPECT_EQ(changed("/block", "c"), "the block file: has changed since the plan was made");
  EXPECT_EQ(changed("/options/x/y", 2), "option x/y: is 2, in the plan 1");
  EXPECT_EQ(changed("/inputs/0/sha256", "d"), "l: has changed since the plan was made");
  EXPECT_EQ(changed("/inputs/0/modified_s", 7), "");  // the content decides
  EXPECT_EQ(changed("/inputs/1/modified_s", 7), "t: has changed since the plan was made");
  EXPECT_EQ(changed("/inputs/1/bytes", 7), "t: has changed since the plan was made");
  EXPECT_EQ(changed("/inputs/1/path", "u"), "u: is no input of the plan");
  auto fewer = planned;
  fewer["inputs"].erase(1);
  EXPECT_EQ(difference(planned, fewer)->how, "is no longer an input");
}

}  // namespace
}  // namespace ridgeline::apps
