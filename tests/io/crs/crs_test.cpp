// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/crs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace ridgeline::io {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// EPSG:25832 as GIS programs of different age and make write it.
const char* const kUtm32Esri =
    R"(PROJCS["ETRS_1989_UTM_Zone_32N",GEOGCS["GCS_ETRS_1989",DATUM["D_ETRS_1989",)"
    R"(SPHEROID["GRS_1980",6378137.0,298.257222101]],PRIMEM["Greenwich",0.0],)"
    R"(UNIT["Degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],)"
    R"(PARAMETER["False_Easting",500000.0],PARAMETER["False_Northing",0.0],)"
    R"(PARAMETER["Central_Meridian",9.0],PARAMETER["Scale_Factor",0.9996],)"
    R"(PARAMETER["Latitude_Of_Origin",0.0],UNIT["Meter",1.0]])";

/// The system with ellipsoidal heights, as a compound of WKT1, which PROJ reads as a system with
/// three axes.
Crs with_ellipsoidal_heights(const Crs& plan) {
  return {R"-(COMPD_CS["ETRS89 / UTM zone 32N + Ellipsoid (metre)",)-" + to_wkt(plan) +
          R"-(,VERT_CS["Ellipsoid (metre)",VERT_DATUM["Ellipsoid",2002],)-"
          R"-(UNIT["metre",1],AXIS["Up",UP]]])-"};
}

TEST(Describe, SplitsACompoundCrs) {
  const CrsFacts facts = describe({"EPSG:25832+7837"});
  EXPECT_EQ(facts.horizontal_name, "ETRS89 / UTM zone 32N");
  EXPECT_EQ(facts.vertical_name, "DHHN2016 height");
  EXPECT_FALSE(facts.is_geographic);
  EXPECT_EQ(facts.horizontal_unit_m, 1.0);
  EXPECT_EQ(facts.vertical_unit_m, 1.0);
}

TEST(Describe, MayHaveBlanksInACode) {
  EXPECT_EQ(describe({"EPSG: 25832 + 7837"}).vertical_name,
            describe({"EPSG:25832+7837"}).vertical_name);
  EXPECT_THROW(describe({"WGS 84 / UTM zone 32N"}), std::invalid_argument);
}

TEST(Describe, StatesFeetExactly) {
  const CrsFacts mixed = describe({"EPSG:2992+6360"});
  EXPECT_EQ(mixed.horizontal_unit_m, 0.3048);
  EXPECT_NEAR(mixed.vertical_unit_m, 1200.0 / 3937.0, 1e-15);
  EXPECT_EQ(mixed.vertical_unit_name, "US survey foot");
}

TEST(Describe, UnknownIsMetresWithoutANameOfAPart) {
  const CrsFacts facts = describe({});
  EXPECT_EQ(facts.name, "unknown");
  EXPECT_EQ(facts.horizontal_name, "");
  EXPECT_EQ(facts.vertical_name, "");
  EXPECT_EQ(facts.horizontal_unit_m, 1.0);
}

TEST(Describe, HeightsWithoutTheirOwnUnitShareTheHorizontalOne) {
  EXPECT_EQ(describe({"EPSG:2992"}).vertical_unit_m, 0.3048);
}

TEST(Describe, SeesDegrees) {
  EXPECT_TRUE(describe({"EPSG:4326"}).is_geographic);
  EXPECT_TRUE(describe({"EPSG:4979"}).is_geographic);
}

TEST(Describe, RefusesWhatIsNoUsableCrs) {
  EXPECT_THROW(describe({"EPSG:999999"}), std::invalid_argument);
  EXPECT_THROW(describe({"no crs at all"}), std::invalid_argument);
  EXPECT_THROW(describe({"+proj=utm +zone=32"}), std::invalid_argument);
  EXPECT_THROW(describe({"EPSG:4978"}), std::invalid_argument);
}

TEST(Describe, RefusesNamesWhichProjWouldSearchFor) {
  for (const char* name : {"foo", "Amersfoort", "WGS 84", "25832", "ETRS89 / UTM zone 32N", ":"}) {
    EXPECT_THROW(describe({name}), std::invalid_argument) << name;
  }
  EXPECT_NO_THROW(describe({"EPSG:25832+EPSG:7837"}));
  EXPECT_NO_THROW(describe({"urn:ogc:def:crs,crs:EPSG::25832,crs:EPSG::7837"}));
  EXPECT_NO_THROW(describe({"+proj=utm +zone=32 +type=crs"}));
  EXPECT_NO_THROW(describe({to_wkt({"EPSG:25832"})}));
}

TEST(Compare, CodeAndItsTextsAgree) {
  const Crs code{"EPSG:25832"};
  for (const Crs& other :
       {code, Crs{to_wkt(code)}, Crs{kUtm32Esri}, Crs{"urn:ogc:def:crs:EPSG::25832"}}) {
    EXPECT_TRUE(compare(code, other).compatible) << other.definition;
    EXPECT_TRUE(compare(other, code).compatible) << other.definition;
    EXPECT_EQ(compare(code, other).warning, "");
  }
}

TEST(Compare, DifferentHorizontalPartsNameBoth) {
  const CrsAgreement agreement = compare({"EPSG:25832"}, {"EPSG:25833"});
  EXPECT_FALSE(agreement.compatible);
  EXPECT_THAT(agreement.reason, AllOf(HasSubstr("ETRS89 / UTM zone 32N"), HasSubstr("zone 33N")));
  EXPECT_EQ(agreement.reason.find("units"), std::string::npos);
}

TEST(Compare, FootAgainstMetreNamesBothUnits) {
  const CrsAgreement agreement = compare({"EPSG:2991"}, {"EPSG:2992"});
  EXPECT_FALSE(agreement.compatible);
  EXPECT_THAT(agreement.reason, AllOf(HasSubstr("metre (1 m)"), HasSubstr("foot (0.3048 m)")));
}

TEST(Compare, InternationalAndSurveyFootDiffer) {
  EXPECT_FALSE(compare({"EPSG:2991+8228"}, {"EPSG:2991+6360"}).compatible);
}

TEST(Compare, DifferentHeightsAreRefusedAndOneUnknownIsWarnedOf) {
  EXPECT_THAT(compare({"EPSG:25832+7837"}, {"EPSG:25832+5783"}).reason,
              AllOf(HasSubstr("vertical"), HasSubstr("DHHN2016"), HasSubstr("DHHN92")));
  const CrsAgreement one = compare({"EPSG:25832+7837"}, {"EPSG:25832"});
  EXPECT_TRUE(one.compatible);
  EXPECT_THAT(one.warning, HasSubstr("tens of metres"));
  EXPECT_EQ(compare({"EPSG:25832"}, {"EPSG:25832"}).warning, "");
}

TEST(Compare, UnknownIsTakenAsEqualWithAWarning) {
  const CrsAgreement agreement = compare({}, {"EPSG:25832"});
  EXPECT_TRUE(agreement.compatible);
  EXPECT_THAT(agreement.warning, HasSubstr("ETRS89 / UTM zone 32N"));
  EXPECT_EQ(compare({}, {}).warning, "");
}

TEST(Compare, HeightsAboveTheEllipsoidLeaveThePlanAsItIs) {
  const Crs plan{"EPSG:25832"};
  const Crs three_axes = with_ellipsoidal_heights(plan);
  const CrsAgreement one = compare(plan, three_axes);
  EXPECT_TRUE(one.compatible) << one.reason;
  EXPECT_THAT(one.warning, AllOf(HasSubstr("only one of two files in \"ETRS89 / UTM zone 32N\""),
                                 HasSubstr("ellipsoidal height"), HasSubstr("tens of metres")));
  EXPECT_TRUE(compare(three_axes, three_axes).compatible);
  EXPECT_EQ(compare(three_axes, three_axes).warning, "");
  const CrsAgreement geoid = compare(three_axes, {"EPSG:25832+7837"});
  EXPECT_THAT(geoid.reason, AllOf(HasSubstr("vertical"), HasSubstr("ellipsoidal height of"),
                                  HasSubstr("DHHN2016")));
  EXPECT_FALSE(compare(three_axes, {"EPSG:25833"}).compatible);
}

TEST(Compare, SystemsOfOneNameAreToldByWhatDiffers) {
  const Crs a{"EPSG:25832"};
  std::string moved = to_wkt(a);
  moved.replace(moved.find("\"central_meridian\",9"), 20, "\"central_meridian\",8");
  for (const char* id : {"\"25832\""}) moved.replace(moved.find(id), 7, "\"99999\"");
  const CrsAgreement agreement = compare(a, {moved});
  EXPECT_FALSE(agreement.compatible);
  EXPECT_THAT(agreement.reason,
              AllOf(HasSubstr("both are called \"ETRS89 / UTM zone 32N\""), HasSubstr("+lon_0=8")));
}

TEST(Compare, HeightsInFeetAreTheSameUnderAnyName) {
  const Crs altered = with_vertical_unit({"EPSG:2264+5703"}, kSurveyFoot_m);
  EXPECT_EQ(describe(altered).vertical_unit_name, "US survey foot");
  EXPECT_TRUE(compare(altered, {"EPSG:2264+6360"}).compatible);
  EXPECT_FALSE(compare(altered, {"EPSG:2264+5703"}).compatible);
  EXPECT_FALSE(compare(altered, {"EPSG:2264+8228"}).compatible);
}

TEST(Describe, SeesThatAPlaneIsNowhere) {
  // GDAL 3.9 writes this for no reference system
  const Crs none{R"(LOCAL_CS["Undefined SRS",LOCAL_DATUM["unknown",32767],UNIT["unknown",0],)"
                 R"(AXIS["Easting",EAST],AXIS["Northing",NORTH]])"};
  EXPECT_TRUE(describe(none).states_nothing());
  EXPECT_FALSE(describe({"EPSG:25832"}).states_nothing());
}

TEST(WithVerticalUnit, LeavesWhatHasNoHeights) {
  EXPECT_EQ(with_vertical_unit({"EPSG:25832"}, kFoot_m).definition, "EPSG:25832");
}

TEST(UnitText, NamesTheUnitsOfSurveys) {
  EXPECT_EQ(unit_text(1.0), "metre (1 m)");
  EXPECT_EQ(unit_text(kFoot_m), "foot (0.3048 m)");
  EXPECT_EQ(unit_text(kSurveyFoot_m), "US survey foot (0.304800609601 m)");
  EXPECT_EQ(unit_text(0.5), "unit (0.5 m)");
}

TEST(ToWkt, WritesHeightsAboveTheEllipsoidAsAVerticalSystem) {
  const Crs three_axes = with_ellipsoidal_heights({"EPSG:25832"});
  EXPECT_THAT(to_wkt(three_axes), HasSubstr("Ellipsoid (metre)"));
  EXPECT_TRUE(compare({to_wkt(three_axes)}, three_axes).compatible);
}

TEST(ToWkt, RefusesAnUnreadableDefinition) {
  EXPECT_THROW(to_wkt({"nonsense"}), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::io
