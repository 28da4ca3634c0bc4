// SPDX-License-Identifier: BSD-3-Clause
#include "io/gdal/polygon_outline.h"

#include "io/error.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

namespace ridgeline::io {
namespace {

using testing::HasSubstr;

std::string geojson(const std::string& geometry) {
  return R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}},)"
         R"("features":[{"type":"Feature","properties":{},"geometry":)" +
         geometry + "}]}";
}

TEST(ConvexHull, HasTheCornersAloneAndRunsCounterClockwise) {
  const std::vector<Eigen::Vector2d> hull =
      convex_hull({{1, 1}, {0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {0, 0}, {2, 1}});
  const std::vector<Eigen::Vector2d> corners{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  EXPECT_EQ(hull, corners);
  EXPECT_LT(convex_hull({{0, 0}, {1, 1}, {2, 2}}).size(), 3U);
  EXPECT_TRUE(convex_hull({}).empty());
}

TEST(PolygonOutline, IsTheHullOfAllPolygonsOfAFile) {
  const TempFolder folder;
  const std::string path = folder.write(
      "area.geojson",
      geojson(R"({"type":"MultiPolygon","coordinates":[[[[0,0],[4,0],[1,1],[0,4],[0,0]]],)"
              R"([[[9,9],[10,9],[10,10],[9,9]]]]})"));
  const PolygonOutline outline = read_polygon_outline(path);
  const std::vector<Eigen::Vector2d> corners{{0, 0}, {4, 0}, {10, 9}, {10, 10}, {0, 4}};
  EXPECT_EQ(outline.corners, corners);
  EXPECT_THAT(describe(outline.crs).name, HasSubstr("UTM zone 32N"));
}

/// RFC 7946 knows no other system than WGS 84, but files in metres without `crs` are common.
TEST(PolygonOutline, OfAGeoJsonWithoutCrsIsInDegreesOnlyIfItCanBe) {
  const TempFolder folder;
  const auto crs_of_square = [&](const std::string& low, const std::string& high) {
    const std::string ring = "[[" + low + "," + low + "],[" + high + "," + low + "],[" + high +
                             "," + high + "],[" + low + "," + low + "]]";
    const std::string text =
        R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[)" + ring +
        "]}}";
    return read_polygon_outline(folder.write("area.geojson", text)).crs;
  };
  EXPECT_FALSE(crs_of_square("5000", "5100").known());
  EXPECT_FALSE(crs_of_square("-20", "91").known());
  EXPECT_TRUE(describe(crs_of_square("49", "50")).is_geographic);
}

TEST(PolygonOutline, IsRefusedWithoutAnArea) {
  const TempFolder folder;
  for (const char* geometry : {R"({"type":"LineString","coordinates":[[0,0],[4,0],[4,4]]})",
                               R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[2,0],[0,0]]]})"}) {
    EXPECT_THROW((void)read_polygon_outline(folder.write("area.geojson", geojson(geometry))),
                 IoError);
  }
  EXPECT_THROW((void)read_polygon_outline(folder.file("missing.gpkg")), MissingFileError);
  EXPECT_THROW((void)read_polygon_outline(folder.write("area.gpkg", "no database")), IoError);
}

}  // namespace
}  // namespace ridgeline::io
