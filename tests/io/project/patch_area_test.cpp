// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/patch_area.h"

#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <yaml-cpp/yaml.h>

namespace ridgeline::io {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Crs kUtm{"EPSG:25832"};

/// A square of 60 m in UTM coordinates.
std::string square_in_metres(const std::string& crs_member) {
  return R"({"type":"FeatureCollection",)" + crs_member +
         R"("features":[{"type":"Feature","properties":{},"geometry":{"type":"Polygon",)"
         R"("coordinates":[[[513030,5403030],[513090,5403030],[513090,5403090],)"
         R"([513030,5403090],[513030,5403030]]]}}]})";
}

TEST(PatchArea, WithoutAReferenceSystemIsInThatOfThePatchAndAWarningSaysSo) {
  const TempFolder folder;
  const std::string file = folder.write("area.geojson", square_in_metres(""));
  const YamlMap patch("patch.yaml", YAML::Load("area: area.geojson"), {"area", "block"});
  std::vector<std::string> warnings;
  EXPECT_EQ(area_of_patch(patch, folder.file(""), kUtm, warnings).size(), 4U);
  EXPECT_THAT(warnings, ElementsAre(AllOf(HasSubstr("area.geojson: states no reference system"),
                                          HasSubstr("of the patch, ETRS89 / UTM zone 32N"))));
}

TEST(PatchArea, InAnotherReferenceSystemIsRefused) {
  const TempFolder folder;
  (void)folder.write("area.geojson",
                     square_in_metres(R"("crs":{"type":"name","properties":{"name":)"
                                      R"("urn:ogc:def:crs:EPSG::25833"}},)"));
  const YamlMap patch("patch.yaml", YAML::Load("area: area.geojson"), {"area", "block"});
  std::vector<std::string> warnings;
  EXPECT_THROW((void)area_of_patch(patch, folder.file(""), kUtm, warnings), IoError);
  EXPECT_THAT(warnings, IsEmpty());
}

}  // namespace
}  // namespace ridgeline::io
