// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/surface_words.h"

#include <gmock/gmock.h>

namespace ridgeline::io {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(SurfaceKindIn, KnowsTheWordsOfCityGmlAndOfPeople) {
  for (const char* const name :
       {"RoofSurface", "roof", "Roofs", "Roof.001", "roof_surface_12", "Dach",
        "Dachfl\xC3\xA4"
        "che",
        "bldg:RoofSurface", "house_1 RoofSurface"})
    EXPECT_EQ(surface_kind_in(name), FaceKind::kRoof) << name;
  EXPECT_EQ(surface_kind_in("house_1-wall"), FaceKind::kWall);
  EXPECT_EQ(surface_kind_in("Wand3"), FaceKind::kWall);
  EXPECT_EQ(surface_kind_in("GroundSurface"), FaceKind::kGround);
  EXPECT_EQ(surface_kind_in("ClosureSurface"), FaceKind::kOther);
  for (const char* const name :
       {"", "house_1", "Proof", "Roofer", "NL.IMBAG.1", "Wallstreet 7", "Surface"})
    EXPECT_EQ(surface_kind_in(name), FaceKind::kUnknown) << name;
}

TEST(WordsWithoutSurfaces, KeepWhatNamesABuilding) {
  EXPECT_THAT(words_without_surfaces("house_1 RoofSurface"), ElementsAre("house_1"));
  EXPECT_THAT(words_without_surfaces("house_1_RoofSurface"), ElementsAre("house_1"));
  EXPECT_THAT(words_without_surfaces("NL.IMBAG.Pand.0503-0 7"),
              ElementsAre("NL.IMBAG.Pand.0503-0", "7"));
  for (const char* const name : {"", "RoofSurface", "Roof.001", "wall-3", "Dach"})
    EXPECT_THAT(words_without_surfaces(name), IsEmpty()) << name;
}

}  // namespace
}  // namespace ridgeline::io
