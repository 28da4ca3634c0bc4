// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/las_crs.h"

#include "tests/io/cloud/las_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>

namespace ridgeline::io {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kProjection = "LASF_Projection";

LasCrs crs_of(LasBytes las) {
  const std::string text = las.add_point({}).bytes();
  const auto bytes = std::as_bytes(std::span(text));
  return read_las_crs(bytes, parse_las_header(bytes, "tile.las"));
}

std::string utm(int zone) { return to_wkt({"EPSG:" + std::to_string(25800 + zone)}); }

TEST(ReadLasCrs, NoRecordIsUnknown) {
  const LasCrs result = crs_of(LasBytes(2, 0));
  EXPECT_FALSE(result.crs.known());
  EXPECT_THAT(result.warnings, IsEmpty());
}

TEST(ReadLasCrs, ReadsWktOfBothUsers) {
  for (const char* const user : {kProjection, "liblas"}) {
    const LasCrs result =
        crs_of(LasBytes(4, 6).add_vlr(user, 2112, utm(32) + std::string(3, '\0')));
    EXPECT_EQ(describe(result.crs).name, "ETRS89 / UTM zone 32N");
    EXPECT_THAT(result.warnings, IsEmpty());
  }
}

TEST(ReadLasCrs, ReadsGeoTiffCodes) {
  const std::string keys = geotiff_directory({{1024, 1}, {3072, 25832}, {4096, 7837}});
  const LasCrs result = crs_of(LasBytes(2, 0).add_vlr(kProjection, 34735, keys));
  EXPECT_EQ(result.crs.definition, "EPSG:25832+7837");
  EXPECT_THAT(result.warnings, IsEmpty());
  const std::string degrees = geotiff_directory({{1024, 2}, {2048, 4326}});
  EXPECT_TRUE(crs_of(LasBytes(2, 0).add_vlr(kProjection, 34735, degrees)).is_geographic);
}

TEST(ReadLasCrs, DisagreementFollowsTheWktBit) {
  const LasBytes both = LasBytes(4, 6)
                            .add_vlr(kProjection, 2112, utm(32))
                            .add_vlr(kProjection, 34735, geotiff_directory({{3072, 25833}}));
  const LasCrs keys = crs_of(both);
  EXPECT_EQ(describe(keys.crs).name, "ETRS89 / UTM zone 33N");
  EXPECT_THAT(keys.warnings, ElementsAre(AllOf(HasSubstr("zone 32N"), HasSubstr("zone 33N"),
                                               HasSubstr("using the keys"))));
  const LasCrs wkt = crs_of(LasBytes(both).set<std::uint16_t>(6, 0x10));
  EXPECT_EQ(describe(wkt.crs).name, "ETRS89 / UTM zone 32N");
  EXPECT_THAT(wkt.warnings, ElementsAre(HasSubstr("using the WKT")));
}

TEST(ReadLasCrs, Las15PrefersWkt) {
  const LasCrs result =
      crs_of(LasBytes(5, 6)
                 .add_vlr(kProjection, 2112, utm(32))
                 .add_vlr(kProjection, 34735, geotiff_directory({{3072, 25833}})));
  EXPECT_EQ(describe(result.crs).name, "ETRS89 / UTM zone 32N");
}

TEST(ReadLasCrs, DamagedRecordsLeaveItUnknownWithAWarning) {
  const std::string user_defined = geotiff_directory({{1024, 1}, {3072, 32767}, {2048, 4258}});
  std::string counts_too_many = geotiff_directory({{3072, 25832}});
  counts_too_many[6] = 9;
  for (const LasBytes& las :
       {LasBytes(2, 0).add_vlr(kProjection, 34735, ""),
        LasBytes(2, 0).add_vlr(kProjection, 34735, counts_too_many),
        LasBytes(2, 0).add_vlr(kProjection, 34735, user_defined),
        LasBytes(2, 0).add_vlr(kProjection, 34735, geotiff_directory({{3072, 999}})),
        LasBytes(4, 6).add_vlr(kProjection, 2112, "PROJCS[\"cut off")}) {
    const LasCrs result = crs_of(las);
    EXPECT_FALSE(result.crs.known());
    EXPECT_THAT(result.warnings,
                ElementsAre(testing::AnyOf(HasSubstr("unknown"), HasSubstr("WKT"))));
  }
}

TEST(ReadLasCrs, ANameIsNoWkt) {
  // PROJ would search its data base for seconds for systems that are like it.
  const LasCrs result = crs_of(LasBytes(2, 0).add_vlr(kProjection, 2112, "COMPD_CSPROJCS[\"x\"]"));
  EXPECT_FALSE(result.crs.known());
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("not a reference system known to PROJ")));
}

TEST(ReadLasCrs, NewFormatsWithKeysOnlyAreWarnedOf) {
  const LasCrs result =
      crs_of(LasBytes(4, 6).add_vlr(kProjection, 34735, geotiff_directory({{3072, 25832}})));
  EXPECT_EQ(result.crs.definition, "EPSG:25832");
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("point format 6 requires a WKT")));
}

TEST(ReadLasCrs, StatedUnitsAreObeyed) {
  const std::string same = geotiff_directory({{3072, 2992}, {3076, 9002}});
  const LasCrs feet = crs_of(LasBytes(2, 0).add_vlr(kProjection, 34735, same));
  EXPECT_EQ(feet.unit_m, Eigen::Vector3d::Constant(0.3048));
  EXPECT_THAT(feet.warnings, IsEmpty());
  const std::string survey_heights = geotiff_directory({{3072, 25832}, {4099, 9003}});
  const LasCrs mixed = crs_of(LasBytes(2, 0).add_vlr(kProjection, 34735, survey_heights));
  EXPECT_EQ(mixed.unit_m, Eigen::Vector3d(1.0, 1.0, 1200.0 / 3937.0));
  EXPECT_THAT(mixed.warnings, ElementsAre(HasSubstr("vertical unit")));
}

LasCrs crs_of_keys(std::initializer_list<std::array<std::uint16_t, 2>> keys) {
  return crs_of(LasBytes(2, 0).add_vlr(kProjection, 34735, geotiff_directory(keys)));
}

TEST(ReadLasCrs, HeightsOfAUserDefinedProjectionFollowItsUnit) {
  constexpr double kUnits[] = {kFoot_m, kSurveyFoot_m};
  for (std::uint16_t k = 0; k < 2; ++k) {
    const auto unit = static_cast<std::uint16_t>(9002 + k);
    const LasCrs result = crs_of_keys({{3072, 32767}, {3076, unit}});
    EXPECT_FALSE(result.crs.known());
    EXPECT_EQ(result.unit_m, Eigen::Vector3d::Constant(kUnits[k]));
    EXPECT_THAT(result.warnings,
                testing::Contains(
                    AllOf(HasSubstr("foot"), HasSubstr("so are its heights, which have no unit"))));
    const LasCrs mixed = crs_of_keys({{3072, 32767}, {3076, unit}, {4099, 9001}});
    EXPECT_EQ(mixed.unit_m, Eigen::Vector3d(kUnits[k], kUnits[k], 1.0));
    EXPECT_THAT(mixed.warnings, testing::Contains(HasSubstr("heights in metre (1 m)")));
    // EPSG's vertical systems state their unit
    const LasCrs metres = crs_of_keys({{3072, 32767}, {3076, unit}, {4096, 5703}});
    EXPECT_EQ(metres.unit_m, Eigen::Vector3d(kUnits[k], kUnits[k], 1.0));
  }
  EXPECT_EQ(crs_of_keys({{3072, 25832}, {3076, 9003}}).unit_m,
            Eigen::Vector3d::Constant(kSurveyFoot_m));
}

TEST(ReadLasCrs, AVerticalDatumTakesTheUnitOfItsKeyOrThePlan) {
  const LasCrs stated = crs_of_keys({{3072, 2264}, {3076, 9003}, {4096, 5103}, {4099, 9003}});
  EXPECT_THAT(stated.warnings, IsEmpty());
  constexpr double kDigitsOfWkt = 1e-14;
  EXPECT_TRUE(stated.unit_m.isApproxToConstant(kSurveyFoot_m, kDigitsOfWkt));
  EXPECT_TRUE(compare(stated.crs, {"EPSG:2264+6360"}).compatible);
  const LasCrs by_plan = crs_of_keys({{3072, 2264}, {4096, 5103}});
  EXPECT_TRUE(compare(by_plan.crs, {"EPSG:2264+6360"}).compatible);
  EXPECT_THAT(by_plan.warnings,
              ElementsAre(HasSubstr("assuming that of the plan, US survey foot")));
  EXPECT_TRUE(
      compare(crs_of_keys({{3072, 32617}, {4096, 5103}}).crs, {"EPSG:32617+5703"}).compatible);
  EXPECT_TRUE(
      compare(crs_of_keys({{3072, 27700}, {4096, 5101}}).crs, {"EPSG:27700+5701"}).compatible);
}

TEST(ReadLasCrs, CodesThatDoNotCombineAreWarnedOf) {
  const LasCrs ellipsoidal = crs_of_keys({{3072, 25832}, {4096, 7901}});  // three-dimensional
  EXPECT_EQ(ellipsoidal.crs.definition, "EPSG:25832");
  EXPECT_THAT(ellipsoidal.warnings, ElementsAre(HasSubstr("key 4096 is 7901")));
  const LasCrs twice = crs_of_keys({{3072, 7415}, {4096, 5709}});  // 7415 is compound
  EXPECT_EQ(twice.crs.definition, "EPSG:7415");
  EXPECT_THAT(twice.warnings, ElementsAre(HasSubstr("key 4096 is 5709")));
  const LasCrs heights_alone = crs_of_keys({{3072, 5703}});
  EXPECT_FALSE(heights_alone.crs.known());
  EXPECT_THAT(heights_alone.warnings,
              ElementsAre(HasSubstr("EPSG:5703, which is not a horizontal")));
}

TEST(ReadLasCrs, AKeyThatChangesTheUnitOfHeightsChangesTheirSystem) {
  const LasCrs result = crs_of_keys({{3072, 2264}, {4096, 5703}, {4099, 9003}});
  EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("vertical unit")));
  EXPECT_TRUE(compare(result.crs, {"EPSG:2264+6360"}).compatible);
}

TEST(ReadLasCrs, APlaneThatIsNowhereIsUnknown) {
  const LasCrs result = crs_of(LasBytes(4, 6).add_vlr(
      kProjection, 2112,
      R"(LOCAL_CS["Undefined SRS",LOCAL_DATUM["unknown",32767],UNIT["unknown",0]])"));
  EXPECT_FALSE(result.crs.known());
  EXPECT_EQ(result.unit_m, Eigen::Vector3d::Ones());
}

}  // namespace
}  // namespace ridgeline::io
