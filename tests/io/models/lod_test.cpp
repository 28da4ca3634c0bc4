// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/lod.h"

#include <gmock/gmock.h>

namespace ridgeline::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Lod = std::optional<std::string>;

TEST(ChosenLod, IsTheHighestOfThoseWanted) {
  EXPECT_EQ(chosen_lod({"0", "1.2", "2", "2.2", "4"}, ""), "2.2");
  EXPECT_EQ(chosen_lod({"0", "1.2", "2", "2.2", "4"}, "2"), "2.2");
  EXPECT_EQ(chosen_lod({"0", "1.2"}, ""), "1.2");
  EXPECT_EQ(chosen_lod({"", "1.2"}, ""), "1.2");
  EXPECT_EQ(chosen_lod({""}, ""), "");
  EXPECT_EQ(chosen_lod({"12"}, "1"), std::nullopt);
}

TEST(LodChoice, ReadsEachPartInItsHighestLevelAndNamesTheOdd) {
  LodChoice choice("");
  EXPECT_THAT(choice.choose({{"b", {"0"}}, {"b-0", {"1.3", "2.2"}}, {"b-1", {"1.2", "1.3"}}}),
              ElementsAre(Lod(), Lod("2.2"), Lod("1.3")));
  EXPECT_THAT(choice.choose({{"c", {"2.2"}}}), ElementsAre(Lod("2.2")));
  EXPECT_THAT(choice.warnings(),
              ElementsAre("1 of 3 buildings and parts is read in LoD 1.3 (most in LoD 2.2): b-1"));
}

TEST(LodChoice, WarnsOfNothingWhereAllAreOfOneLevel) {
  LodChoice choice("");
  (void)choice.choose({{"b", {"0"}}, {"b-0", {"1.3", "2.2"}}});
  (void)choice.choose({{"c", {"2.2"}}});
  (void)choice.choose({{"d", {}}});
  EXPECT_THAT(choice.warnings(), IsEmpty());
}

TEST(LodChoice, APartWithoutTheWantedLevelIsReadInItsHighest) {
  LodChoice choice("1.3");
  EXPECT_THAT(choice.choose(
                  {{"b", {}}, {"b-0", {"1.3", "2.2"}}, {"b-1", {"1.2", "2.2"}}, {"b-2", {"1.3"}}}),
              ElementsAre(Lod(), Lod("1.3"), Lod("2.2"), Lod("1.3")));
  EXPECT_THAT(choice.warnings(), ElementsAre(HasSubstr("read in LoD 2.2 (most in LoD 1.3): b-1")));
  // a building without the wanted level is not read
  EXPECT_THAT(choice.choose({{"c", {"2.2"}}}), ElementsAre(Lod()));
}

TEST(LodChoice, ReadsTheOutlineOfTheWholeOrItsPartsButNotBoth) {
  const std::vector<LodObject> objects{{"b", {"1"}}, {"b-0", {"2"}}, {"b-1", {"2"}}};
  LodChoice highest("");
  EXPECT_THAT(highest.choose(objects), ElementsAre(Lod(), Lod("2"), Lod("2")));
  EXPECT_THAT(highest.warnings(),
              ElementsAre("1 of 3 buildings and parts is left out, as the faces in LoD 1 repeat "
                          "those of another level: b"));
  LodChoice lowest("1");
  EXPECT_THAT(lowest.choose(objects), ElementsAre(Lod("1"), Lod(), Lod()));
  EXPECT_THAT(lowest.warnings(), ElementsAre(HasSubstr("2 of 3 buildings and parts are left out")));
}

TEST(LodChoice, CountsThoseThatHaveNoFacesInALevelThatIsRead) {
  LodChoice choice("");
  // the footprint of a building is its outline, that of a part is all that there is
  (void)choice.choose({{"b", {"0"}}, {"b-0", {"0", "2.2"}}, {"b-1", {"0"}}});
  (void)choice.choose({{"c", {"0"}}, {"c-0", {}}});
  EXPECT_THAT(choice.warnings(),
              ElementsAre("2 of 3 buildings and parts are left out, as there are "
                          "no faces in LoD 1 to 3: b-1, c"));
  LodChoice wanted("2.2");
  (void)wanted.choose({{"b", {"2.2"}}});
  (void)wanted.choose({{"c", {"1.3"}}});
  EXPECT_THAT(wanted.warnings(), ElementsAre(HasSubstr("1 of 2 buildings and parts is left out, as "
                                                       "there are no faces in LoD 2.2: c")));
}

TEST(LodChoice, TheFirstFiveOfManyAreNamed) {
  LodChoice choice("");
  for (int i = 0; i < 10; ++i) (void)choice.choose({{std::to_string(i), {"2"}}});
  for (int i = 10; i < 17; ++i) (void)choice.choose({{std::to_string(i), {"1"}}});
  EXPECT_THAT(choice.warnings(), ElementsAre(HasSubstr(": 10, 11, 12, 13, 14 and 2 more")));
}

}  // namespace
}  // namespace ridgeline::io
