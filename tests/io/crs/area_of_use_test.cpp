// SPDX-License-Identifier: BSD-3-Clause
#include "io/crs/area_of_use.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace ridgeline::io {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kWktOfPix4d =
    R"(PROJCS["WGS 84 / UTM zone 32N",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",9],PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1],AUTHORITY["EPSG","32632"]])";

std::string warning_at(const char* crs, double x_m, double y_m) {
  return check_area_of_use({crs}, {{x_m, y_m, 0.0}});
}

TEST(CheckAreaOfUse, IsSilentInside) {
  EXPECT_THAT(warning_at("EPSG:25832", 513000.0, 5403000.0), IsEmpty());
  EXPECT_THAT(warning_at("EPSG:25832+7837", 513000.0, 5403000.0), IsEmpty());
  EXPECT_THAT(warning_at(kWktOfPix4d, 513000.0, 5403000.0), IsEmpty());
  // New Zealand lies on both sides of 180 degrees
  EXPECT_THAT(warning_at("EPSG:3994", 6300000.0, -3670000.0), IsEmpty());
  EXPECT_THAT(warning_at("EPSG:3994", 7500000.0, -3670000.0), IsEmpty());
}

TEST(CheckAreaOfUse, WarnsUpTo300KmOutside) {
  EXPECT_THAT(warning_at("EPSG:32632", -320.0, -200.0),
              HasSubstr("around x = -320, y = -200 are 166 km outside the area of use"));
  EXPECT_THAT(warning_at(kWktOfPix4d, -320.0, -200.0), HasSubstr("166 km outside"));
}

TEST(CheckAreaOfUse, RefusesPositionsBeyond) {
  EXPECT_THROW(warning_at("EPSG:25832", -320.0, -200.0), std::invalid_argument);
  EXPECT_THROW(warning_at("EPSG:32632", 4157665.0, 671679.0), std::invalid_argument);
  EXPECT_THROW(warning_at("EPSG:2056", 513000.0, 5403000.0), std::invalid_argument);
}

TEST(CheckAreaOfUse, ComparesTheMedian) {
  EXPECT_THAT(
      check_area_of_use({"EPSG:25832"},
                        {{513000.0, 5403000.0, 1.0}, {0.0, 0.0, 0.0}, {513100.0, 5403000.0, 1.0}}),
      IsEmpty());
}

TEST(CheckAreaOfUse, HasNothingToSayWithoutAnArea) {
  EXPECT_THAT(warning_at("", 1.0, 2.0), IsEmpty());
  EXPECT_THAT(warning_at("+proj=tmerc +lat_0=0 +lon_0=9.1 +ellps=GRS80 +type=crs", 1.0, 2.0),
              IsEmpty());
  EXPECT_THAT(warning_at("EPSG:7837", 1.0, 2.0), IsEmpty());
  EXPECT_THAT(check_area_of_use({"EPSG:25832"}, {}), IsEmpty());
}

}  // namespace
}  // namespace ridgeline::io
