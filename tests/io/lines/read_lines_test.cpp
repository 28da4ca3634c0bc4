// SPDX-License-Identifier: BSD-3-Clause
// GeoJSON, CSV, WKT and what is the same for all formats.
#include "io/lines/read_lines.h"

#include "tests/io/lines/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace ridgeline::io {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const ReadLinesOptions kDefaults;

LineSet read(std::string_view name,
             std::string_view content,
             const ReadLinesOptions& options = kDefaults) {
  const TempFolder folder;
  return read_lines(folder.write(name, content), options);
}

std::string error_of(std::string_view name, std::string_view content) {
  const TempFolder folder;
  const std::string path = folder.write(name, content);
  return io_error_of([&] { read_lines(path); });
}

std::vector<std::string> ids(const LineSet& set) {
  std::vector<std::string> result;
  for (const Line& line : set.lines) result.push_back(line.id);
  return result;
}

std::string collection(const std::string& features, const std::string& crs = "null") {
  return R"({"type":"FeatureCollection","crs":)" + crs + R"(,"features":[)" + features + "]}";
}

std::string feature(const std::string& properties, const std::string& geometry) {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":)" + geometry + "}";
}

std::string line_string(const std::string& coordinates) {
  return R"({"type":"LineString","coordinates":)" + coordinates + "}";
}

TEST(ReadGeoJson, NumbersSegmentsOfAPolylineBelowItsId) {
  const std::string three = line_string("[[0,0,1],[3,0,1],[3,4,1]]");
  const LineSet set = read(
      "a.geojson", collection(feature(R"({"id":"roof"})", three) + "," + feature("null", three) +
                              "," + feature(R"({"id":12})", line_string("[[0,0,1],[9,0,2]]"))));
  EXPECT_THAT(ids(set), ElementsAre("roof.0", "roof.1", "1.0", "1.1", "12"));
  EXPECT_EQ(set.lines[1].parent_id, "roof");
  EXPECT_EQ(set.lines[4].parent_id, "");
  EXPECT_EQ(set.lines[1].segment_in_world.start, Eigen::Vector3d(3, 0, 1));
  EXPECT_EQ(set.lines[1].segment_in_world.end, Eigen::Vector3d(3, 4, 1));
  EXPECT_EQ(set.format, "GeoJSON");
}

TEST(ReadGeoJson, TakesMultiLineStringsAndTheFeaturesOwnId) {
  const LineSet set = read("a.json", R"({"type":"Feature","id":5,"properties":{},"geometry":
      {"type":"MultiLineString","coordinates":[[[0,0,0],[1,0,1]],[[5,0,0],[6,0,1]]]}})");
  EXPECT_THAT(ids(set), ElementsAre("5.0", "5.1"));
  EXPECT_EQ(set.lines[1].segment_in_world.start.x(), 5.0);
}

TEST(ReadGeoJson, UnderstandsCovariancesInEveryForm) {
  std::string flat = "[4";
  for (int i = 1; i < 36; ++i) flat += i % 7 == 0 ? ",4" : ",0.5";
  flat += "]";
  const std::string line = line_string("[[0,0,0],[5,0,1]]");
  const std::string sigmas = R"({"sigma_start_m":[1,2,3],"sigma_end_m":[4,5,6]})";
  const LineSet set =
      read("a.geojson", collection(feature(R"({"covariance":)" + flat + "}", line) + "," +
                                   feature(R"({"covariance":")" + flat + "\"}", line) + "," +
                                   feature(sigmas, line) + "," + feature("{}", line)));
  for (const int i : {0, 1}) {
    ASSERT_TRUE(set.lines[i].covariance_m2.has_value());
    EXPECT_EQ((*set.lines[i].covariance_m2)(3, 3), 4.0);
    EXPECT_EQ((*set.lines[i].covariance_m2)(3, 4), 0.5);
  }
  ASSERT_TRUE(set.lines[2].covariance_m2.has_value());
  EXPECT_EQ((*set.lines[2].covariance_m2)(2, 2), 9.0);
  EXPECT_EQ((*set.lines[2].covariance_m2)(5, 5), 36.0);
  EXPECT_EQ((*set.lines[2].covariance_m2)(0, 1), 0.0);
  EXPECT_FALSE(set.lines[3].covariance_m2.has_value());
}

TEST(ReadGeoJson, RefusesAttributesOfTheWrongShape) {
  const std::string line = line_string("[[0,0,0],[5,0,1]]");
  EXPECT_THAT(error_of("a.geojson", collection(feature(R"({"covariance":[1,2]})", line))),
              HasSubstr("a.geojson: feature 0: covariance = [1,2]; must be 36 numbers"));
  EXPECT_THAT(error_of("a.geojson", collection(feature(R"({"n_points":1.5})", line))),
              HasSubstr("n_points = 1.5; must be an integer"));
  EXPECT_THAT(error_of("a.geojson", collection(feature(R"({"epipolar_angle_deg":"x"})", line))),
              HasSubstr("epipolar_angle_deg = \"x\"; must be a number"));
}

TEST(ReadGeoJson, KeepsLinesWithoutCoordinatesAndWarnsOfThoseThatSayNoReason) {
  const LineSet set =
      read("a.geojson", collection(feature(R"({"status":"not_reconstructed"})", "null") + "," +
                                   feature("{}", line_string("[[null,0,0],[5,0,1]]")) + "," +
                                   feature("{}", line_string("[[1,0,0]]")) + "," +
                                   feature("{}", line_string("[[1,0,0],[5,0,1]]"))));
  ASSERT_EQ(set.lines.size(), 4U);
  EXPECT_EQ(set.lines[0].status, "not_reconstructed");
  EXPECT_FALSE(all_finite(set.lines[0].segment_in_world));
  EXPECT_FALSE(all_finite(set.lines[1].segment_in_world));
  EXPECT_EQ(length(set.lines[2].segment_in_world), 0.0);
  EXPECT_THAT(set.warnings, Contains(HasSubstr("1 of 4 lines have coordinates that are not")));
}

TEST(ReadGeoJson, HonoursTheCrsMember) {
  const std::string one = feature("{}", line_string("[[652000,6862000,30],[652009,6862000,31]]"));
  const std::string crs = R"({"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2154"}})";
  EXPECT_EQ(read("a.geojson", collection(one, crs)).crs.definition, "urn:ogc:def:crs:EPSG::2154");
  const ReadLinesOptions options{.assume_crs = {"EPSG:25832"}};
  EXPECT_EQ(read("a.geojson", collection(one, crs), options).crs.definition, "EPSG:25832");
}

TEST(ReadGeoJson, RefusesDegrees) {
  const std::string degrees = feature("{}", line_string("[[9.17,48.78,250],[9.1701,48.78,250]]"));
  const std::string wgs84 =
      R"({"type":"name","properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}})";
  EXPECT_THAT(error_of("a.geojson", collection(degrees, wgs84)),
              HasSubstr("coordinates in degrees"));
  EXPECT_THAT(error_of("a.geojson", R"({"type":"FeatureCollection","features":[)" + degrees + "]}"),
              HasSubstr("the coordinates are degrees by their size"));
}

TEST(ReadGeoJson, TakesShortCoordinatesOfALocalFrameAsMetres) {
  const std::string local = feature("{}", line_string("[[1,2,3],[9,2,3]]"));
  const LineSet set =
      read("a.geojson", R"({"type":"FeatureCollection","features":[)" + local + "]}");
  EXPECT_EQ(set.lines.size(), 1U);
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("no crs member")));
}

TEST(ReadGeoJson, CountsFeaturesThatAreNoLines) {
  const LineSet set =
      read("a.geojson", collection(feature("{}", R"({"type":"Point","coordinates":[1,2,3]})") +
                                   "," + feature("{}", line_string("[[1,2,3],[9,2,3]]"))));
  EXPECT_THAT(ids(set), ElementsAre("1"));
  EXPECT_THAT(set.warnings, ElementsAre("1 features are no lines: Point"));
}

TEST(ReadGeoJson, SaysWhatIsWrong) {
  EXPECT_THAT(error_of("a.geojson", ""), HasSubstr("a.geojson: is no GeoJSON"));
  EXPECT_THAT(error_of("a.geojson", "{\"type\":\n \"Feature"), HasSubstr("at line 2, column"));
  EXPECT_THAT(error_of("a.geojson", "\x7F\x45LF\x01"), HasSubstr("is no GeoJSON"));
  EXPECT_THAT(error_of("a.geojson", "[1,2]"), HasSubstr("an object with \"type\""));
  EXPECT_THAT(error_of("a.geojson", R"({"type":"FeatureCollection"})"),
              HasSubstr("\"features\" is missing"));
  EXPECT_THAT(error_of("a.geojson", collection(feature("{}", line_string("[[1,2],[3,\"x\",4]]")))),
              HasSubstr("feature 0: coordinate \"x\" is no number"));
  EXPECT_THAT(error_of("a.geojson", collection(feature("{}", line_string("[[1,2],[3]]")))),
              HasSubstr("position [3]; must be [x, y, z]"));
}

TEST(ReadGeoJson, RefusesArraysTooDeepForARecursion) {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  EXPECT_THAT(error_of("a.geojson", collection(feature("{}", line_string(deep)))),
              HasSubstr("too deep"));
  EXPECT_THAT(error_of("a.csv", "x1,y1,z1,x2,y2,z2,covariance\n1,2,3,4,5,6,\"" + deep + "\"\n"),
              HasSubstr("must be a number"));
}

TEST(ReadCsv, NamesAnAttributeOfBytesThatAreNoText) {
  EXPECT_THAT(error_of("a.csv", "x1,y1,z1,x2,y2,z2,n_points\n1,2,3,4,5,6,\xFF\xFE\n"),
              HasSubstr("a.csv:2: n_points"));
}

TEST(ReadLines, RefusesLinesWithoutHeights) {
  EXPECT_THAT(error_of("a.geojson", collection(feature("{}", line_string("[[1,2],[9,2]]")))),
              HasSubstr("the lines have no z; 3D lines are needed"));
}

TEST(ReadLines, WarnsOfHeightsThatAreAllZero) {
  const LineSet set = read("a.csv", "1,2,0,5,2,0\n3,2,0,9,2,0\n");
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("all z are 0")));
}

TEST(ReadLines, KeepsRepeatedIds) {
  const LineSet set = read("a.csv", "id,x1,y1,z1,x2,y2,z2\na,1,2,3,5,2,0\na,3,2,0,9,2,0\n");
  EXPECT_THAT(ids(set), ElementsAre("a", "a"));
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("1 lines have an id that an earlier line has")));
}

TEST(ReadLines, NamesTheFileAndTheRule) {
  EXPECT_THAT(io_error_of([] { read_lines("/nowhere/a.csv"); }), "/nowhere/a.csv: no such file");
  EXPECT_THAT(error_of("a.tif", "II*"),
              HasSubstr("extension '.tif'; lines are read from .geojson"));
  EXPECT_THAT(error_of("a.bin", "x"), HasSubstr("Line3D++ .bin"));
  EXPECT_THAT(error_of("a.npy", "x"), HasSubstr("pickle"));
  EXPECT_THAT(error_of("a.csv", ""), HasSubstr("is empty"));
  EXPECT_THAT(error_of("a.txt", "\n \n"), HasSubstr("is empty"));
}

TEST(ReadCsv, TakesColumnsInAnyOrderWithOthersBetween) {
  const LineSet set = read("a.csv",
                           "z1,note,y1,x1,Class,x2,y2,z2,ID\r\n"
                           "3,\"a, \"\"b\"\"\",2,1,aligned,4,5,6,k7\r\n");
  ASSERT_EQ(set.lines.size(), 1U);
  EXPECT_EQ(set.lines[0].segment_in_world.start, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(set.lines[0].segment_in_world.end, Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(set.lines[0].id, "k7");
  EXPECT_EQ(set.lines[0].line_class, "aligned");
}

TEST(ReadCsv, TakesSixBareNumbersAndOtherSeparators) {
  EXPECT_THAT(ids(read("a.csv", "1,2,3,4,5,6\n7,8,9,1,2,3\n")), ElementsAre("0", "1"));
  const LineSet set = read("a.csv", "x1;y1;z1;x2;y2;z2\n1;2;3;4;5;6\n");
  EXPECT_EQ(set.lines.at(0).segment_in_world.end.z(), 6.0);
}

TEST(ReadCsv, KeepsNaN) {
  const LineSet set = read("a.csv", "1,2,nan,4,5,6\n7,8,9,1,2,inf\n7,8,9,1,2,3\n");
  EXPECT_EQ(set.lines.size(), 3U);
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("2 of 3 lines")));
}

TEST(ReadCsv, NamesTheRowThatIsWrong) {
  EXPECT_THAT(error_of("a.csv", "x1,y1,z1,x2,y2,z2\n1,2,3,4,5,6\n1,2,3,4\n"),
              HasSubstr("a.csv:3: 4 fields; the first row has 6"));
  EXPECT_THAT(error_of("a.csv", "x1,y1,z1,x2,y2,z2\n1,2,3,4,5,six\n"),
              HasSubstr("a.csv:2: 'six' is no number"));
  EXPECT_THAT(error_of("a.csv", "x1,y1,x2,y2\n"), HasSubstr("a.csv:1: no column z1"));
  EXPECT_THAT(error_of("a.csv", "x1,y1,z1,x2,y2,z2,\"id\n"), HasSubstr("is not closed"));
}

TEST(ReadCsv, TakesAColumnOfWkt) {
  const LineSet set = read("a.csv",
                           "id,WKT\n"
                           "a,\"LINESTRING Z (1 2 3,4 5 6)\"\n"
                           "b,\"MULTILINESTRING Z ((1 2 3,4 5 6),(7 8 9,1 2 3))\"\n"
                           "c,\n");
  EXPECT_THAT(ids(set), ElementsAre("a", "b.0", "b.1", "c"));
  EXPECT_EQ(set.lines[2].segment_in_world.start, Eigen::Vector3d(7, 8, 9));
  EXPECT_FALSE(all_finite(set.lines[3].segment_in_world));
  EXPECT_THAT(error_of("a.csv", "id,wkt\na,\"POINT Z (1 2 3)\"\n"),
              HasSubstr("a.csv:2: POINT; must"));
  EXPECT_THAT(error_of("a.csv", "id,wkt\na,\"LINESTRING Z (1 2\"\n"), HasSubstr("is no WKT"));
}

TEST(ReadWkt, TakesOneGeometryARowAndTheSrid) {
  const LineSet set = read("a.wkt",
                           "LINESTRING Z (1 2 3, 4 5 6)\n"
                           "SRID=25832;LINESTRING Z (1 2 3, 4 5 6, 7 8 9)\n");
  EXPECT_THAT(ids(set), ElementsAre("0", "1.0", "1.1"));
  EXPECT_EQ(set.crs.definition, "EPSG:25832");
  EXPECT_EQ(set.format, "WKT");
}

TEST(ReadWkt, RefusesASridThatIsNoCodeNamingTheRow) {
  EXPECT_THAT(error_of("a.wkt", "SRID=58x;LINESTRING Z (1 2 3, 4 5 6)\n"),
              HasSubstr("a.wkt:1: SRID '58x'"));
  EXPECT_THAT(error_of("a.wkt", "SRID=99999;LINESTRING Z (1 2 3, 4 5 6)\n"),
              HasSubstr("a.wkt: its reference system cannot be used"));
}

}  // namespace
}  // namespace ridgeline::io
