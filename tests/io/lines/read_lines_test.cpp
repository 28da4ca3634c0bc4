// SPDX-License-Identifier: BSD-3-Clause
// GeoJSON, CSV, WKT and what is the same for all formats.
#include "io/lines/read_lines.h"

#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace ridgeline::io {
namespace {

using ::testing::AllOf;
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

TEST(ReadGeoJson, LeavesColumnsOfOtherToolsThatHaveOurNames) {
  const std::string line = line_string("[[0,0,0],[5,0,1]]");
  const LineSet set =
      read("a.geojson",
           collection(
               feature(R"({"n_points":7,"covariance":[1,2],"n_images":2})", line) + "," +
               feature(R"({"n_points":"about 120","epipolar_angle_deg":"x","n_images":3})", line)));
  // a column is read as a whole or not at all
  EXPECT_FALSE(set.lines[0].n_points.has_value());
  EXPECT_FALSE(set.lines[0].covariance_m2.has_value());
  EXPECT_EQ(set.lines[0].n_images, 2);
  EXPECT_EQ(set.lines[1].n_images, 3);
  EXPECT_THAT(set.warnings, ElementsAre("column covariance has another meaning in this file and is "
                                        "ignored: [1,2] in feature 0 must be 36 numbers",
                                        "column epipolar_angle_deg has another meaning in this "
                                        "file and is ignored: \"x\" in feature 1 must be a number",
                                        "column n_points has another meaning in this file and is "
                                        "ignored: \"about 120\" in feature 1 must be a number"));
  // columns that are not read stay in the map
  EXPECT_EQ(set.features.columns.size(), 4U);
}

TEST(ReadGeoJson, RefusesVariancesThatNoLineHasNamingTheLine) {
  std::string flat = "[-0.5";
  for (int i = 1; i < 36; ++i) flat += i % 7 == 0 ? ",4" : ",0";
  const std::string line = line_string("[[0,0,0],[5,0,1]]");
  EXPECT_THAT(
      error_of("a.geojson", collection(feature(R"({"id":"r3","covariance":)" + flat + "]}", line))),
      HasSubstr("a.geojson: feature 0: covariance of line r3: the variance is -0.5 m2 for the "
                "start's x; must"));
  EXPECT_THAT(
      error_of("a.geojson",
               collection(feature(R"({"sigma_start_m":[1,2,3],"sigma_end_m":[4,5,-6]})", line))),
      HasSubstr("the variance is -36 m2 for the end's z"));
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
  EXPECT_THAT(set.warnings, Contains(HasSubstr("1 of 4 lines have non-finite")));
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
              HasSubstr("the coordinates are degrees"));
  EXPECT_THAT(error_of("a.geojson", R"({"type":"FeatureCollection","features":[)" + degrees + "]}"),
              HasSubstr("the coordinates look like degrees"));
}

TEST(ReadGeoJson, TakesShortCoordinatesOfALocalFrameAsMetres) {
  const std::string local = feature("{}", line_string("[[1,2,3],[9,2,3]]"));
  const LineSet set =
      read("a.geojson", R"({"type":"FeatureCollection","features":[)" + local + "]}");
  EXPECT_EQ(set.lines.size(), 1U);
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("no crs member")));
}

const std::string kPoint = R"({"type":"Point","coordinates":[1,2,3]})";

std::string polygon(const std::string& ring) {
  return R"({"type":"Polygon","coordinates":[)" + ring + "]}";
}

/// Two roofs that meet at a ridge from (0, 4, 8) to (9, 4, 8).
const std::string kTwoRoofs = feature("{}", polygon("[[0,0,5],[9,0,5],[9,4,8],[0,4,8],[0,0,5]]")) +
                              "," +
                              feature("{}", polygon("[[0,8,5],[0,4,8],[9,4,8],[9,8,5],[0,8,5]]"));

TEST(ReadGeoJson, CountsByKindWhatIsNoLine) {
  const LineSet set = read(
      "a.geojson",
      collection(feature("{}", kPoint) + "," +
                 feature("{}", R"({"type":"MultiPoint","coordinates":[[1,2,3],[1,2,4]]})") + "," +
                 feature("{}", polygon("[[0,0],[9,0],[9,4],[0,0]]")) + "," + kTwoRoofs + "," +
                 feature("{}", "null") + "," + feature("{}", line_string("[[1,2],[9,2]]")) + "," +
                 feature("{}", line_string("[[1,2,3],[9,2,3]]"))));
  EXPECT_THAT(ids(set), ElementsAre("5", "6", "7"));
  EXPECT_THAT(
      set.warnings,
      ElementsAre("2 of 3 lines have non-finite coordinates: 1 line without z, 1 null geometry",
                  "ignored: 3 points, 2 polygons with heights, 1 polygon without heights"));
}

TEST(ReadGeoJson, RefusesFeaturesWithoutALineNamingTheirKinds) {
  const std::string flat = feature("{}", polygon("[[0,0],[9,0],[9,4],[0,0]]"));
  EXPECT_THAT(error_of("a.geojson", collection(flat + "," + flat + "," + feature("{}", kPoint) +
                                               "," + feature("{}", "null"))),
              AllOf(HasSubstr("a.geojson: has no 3D lines but 1 null geometry, 1 point, 2 "
                              "polygons without heights"),
                    HasSubstr("3D lines, or polygons or faces with heights, are needed")));
  // a status of another tool is no reason for a line to be nowhere
  EXPECT_THAT(error_of("a.geojson", collection(feature(R"({"status":"demolished"})", "null"))),
              HasSubstr("1 null geometry"));
  // an empty result is a result, too
  EXPECT_THAT(read("a.geojson", collection("")).warnings, ElementsAre("has no lines"));
}

TEST(ReadGeoJson, FindsLinesInCollectionsHoweverDeep) {
  const std::string one = line_string("[[1,2,3],[9,2,3]]");
  const std::string many =
      R"({"type":"MultiLineString","coordinates":[[[1,0,0],[2,0,0]],[[3,0,0],[4,0,0]]]})";
  const auto group = [](const std::string& members) {
    return R"({"type":"GeometryCollection","geometries":[)" + members + "]}";
  };
  const LineSet set =
      read("a.geojson", collection(feature(R"({"id":"a"})", group(one + "," + kPoint)) + "," +
                                   feature(R"({"id":"b"})", group(group(many + "," + one)))));
  EXPECT_THAT(ids(set), ElementsAre("a", "b.0", "b.1", "b.2"));
  EXPECT_EQ(set.lines[2].segment_in_world.start.x(), 3.0);
  EXPECT_THAT(set.warnings, ElementsAre("ignored: 1 point"));
}

TEST(ReadGeoJson, TakesTheEdgesOfPolygonsWithHeightsThoseOfNeighboursOnce) {
  const LineSet set = read("a.geojson", collection(kTwoRoofs));
  EXPECT_THAT(ids(set), ElementsAre("0.0", "0.1", "0.2", "0.3", "1.0", "1.1", "1.2"));
  EXPECT_EQ(set.lines[2].segment_in_world.start, Eigen::Vector3d(9, 4, 8));
  EXPECT_EQ(set.format, "GeoJSON, edges of polygons");
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("the 7 edges of 2 polygons with heights")));
  // a neighbour may have a vertex on the common edge, and other last digits
  const std::string other =
      feature("{}", polygon("[[0,8,5],[0,4,8],[5,4,8],[9,4.0000001,8],[9,8,5],[0,8,5]]"));
  const std::string first = kTwoRoofs.substr(0, kTwoRoofs.find("},{") + 1);
  EXPECT_EQ(read("a.geojson", collection(first + "," + other)).lines.size(), 7U);
}

TEST(ReadGeoJson, NamesAFileOfAnotherKind) {
  EXPECT_THAT(error_of("city.json", R"({"type":"CityJSONFeature","vertices":[]})"),
              HasSubstr("city.json: is a CityJSON feature, give the whole file"));
  EXPECT_THAT(error_of("a.json", R"({"type":"Topology","objects":{}})"), HasSubstr("TopoJSON"));
  EXPECT_THAT(error_of("a.json", R"({"geometryType":"esriGeometryPolyline","features":[]})"),
              HasSubstr("Esri"));
  EXPECT_THAT(error_of("a.geojson", "LASF\1\2"),
              HasSubstr("is a LAS point cloud, not a file of 3D lines; give it as `cloud`"));
  EXPECT_THAT(error_of("a.json", "<?xml version='1.0'?><CityModel/>"), HasSubstr("is not CityGML"));
  EXPECT_THAT(error_of("a.csv", std::string("\xFF\xFEx\0", 4)), HasSubstr("UTF-16"));
  EXPECT_THAT(error_of("a.gml", "<gml/>"),
              HasSubstr("is XML, such as GML, which is not supported"));
}

TEST(ReadGeoJson, OfLatin1BecomesUtf8) {
  const std::string line = line_string("[[1,2,3],[9,2,3]]");
  const LineSet set = read("a.geojson", collection(feature("{\"id\":\"Stra\xDF"
                                                           "e\"}",
                                                           line)));
  EXPECT_EQ(set.lines[0].id,
            "Stra\xC3\x9F"
            "e");
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("reading it as Latin-1")));
}

TEST(ReadGeoJson, SaysWhatIsWrong) {
  EXPECT_THAT(error_of("a.geojson", ""), HasSubstr("a.geojson: is not GeoJSON"));
  EXPECT_THAT(error_of("a.geojson", "{\"type\":\n \"Feature"), HasSubstr("at line 2, column"));
  EXPECT_THAT(error_of("a.geojson", "\x7F\x45LF\x01"), HasSubstr("is not GeoJSON"));
  EXPECT_THAT(error_of("a.geojson", "[1,2]"), HasSubstr("an object with \"type\""));
  EXPECT_THAT(error_of("a.geojson", R"({"type":"FeatureCollection"})"),
              HasSubstr("\"features\" is missing"));
  EXPECT_THAT(error_of("a.geojson", collection(feature("{}", line_string("[[1,2],[3,\"x\",4]]")))),
              HasSubstr("feature 0: coordinate \"x\" is not a number"));
  EXPECT_THAT(error_of("a.geojson", collection(feature("{}", line_string("[[1,2],[3]]")))),
              HasSubstr("position [3]; must be [x, y, z]"));
}

TEST(ReadGeoJson, RefusesArraysTooDeepForARecursion) {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  EXPECT_THAT(error_of("a.geojson", collection(feature("{}", line_string(deep)))),
              HasSubstr("too deep"));
  const LineSet set = read("a.csv", "x1,y1,z1,x2,y2,z2,covariance\n1,2,3,4,5,6,\"" + deep + "\"\n");
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("in row 2 must be 36 numbers")));
}

TEST(ReadCsv, TakesBytesThatAreNoUtf8AsLatin1) {
  const LineSet set = read("a.csv", "id,x1,y1,z1,x2,y2,z2,n_points\n\xDCz,1,2,3,4,5,6,\xFF\xFE\n");
  EXPECT_EQ(set.lines[0].id, "\xC3\x9Cz");
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("column n_points has another meaning"),
                                        HasSubstr("reading it as Latin-1")));
}

TEST(ReadLines, RefusesLinesWithoutHeights) {
  EXPECT_THAT(error_of("a.geojson", collection(feature("{}", line_string("[[1,2],[9,2]]")))),
              HasSubstr("has no 3D lines but 1 line without z; 3D lines, or"));
}

TEST(ReadLines, WarnsOfHeightsThatAreAllZero) {
  const LineSet set = read("a.csv", "1,2,0,5,2,0\n3,2,0,9,2,0\n");
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("all z are 0")));
}

TEST(ReadLines, NumbersRepeatedIdsNeverByThatOfAnotherLine) {
  std::string csv = "id,x1,y1,z1,x2,y2,z2\n";
  for (const char* const id : {"12", "12", "12.1", "12", "a"})
    csv += std::string(id) + ",1,2,3,5,2,0\n";
  const LineSet set = read("a.csv", csv);
  EXPECT_THAT(ids(set), ElementsAre("12", "12.2", "12.1", "12.3", "a"));
  EXPECT_THAT(set.warnings,
              ElementsAre("2 lines repeat the id of an earlier line and get a number: 12.2, 12.3"));
}

TEST(ReadLines, NumbersOfPartsGiveWayToIdsOfTheFile) {
  const std::string three = line_string("[[0,0,1],[3,0,1],[3,4,1]]");
  const std::string one = line_string("[[0,0,1],[3,0,1]]");
  const LineSet set = read("a.geojson", collection(feature(R"({"id":12})", three) + "," +
                                                   feature(R"({"id":12})", three) + "," +
                                                   feature(R"({"id":"12.1"})", one)));
  EXPECT_THAT(ids(set), ElementsAre("12.0", "12.1.1", "12.0.1", "12.1.2", "12.1"));
}

TEST(ReadLines, FeaturesWithoutAnIdAreNumberedPastThoseThatHaveThatNumber) {
  const std::string one = line_string("[[0,0,1],[3,0,1]]");
  const LineSet set =
      read("a.geojson", collection(feature(R"({"id":1})", one) + "," + feature("{}", one)));
  EXPECT_THAT(ids(set), ElementsAre("1", "1.1"));
}

std::string dense(const std::vector<Eigen::Vector3d>& corners, int n) {
  std::string positions;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    for (int k = i == 1 ? 0 : 1; k <= n; ++k) {
      const Eigen::Vector3d x = corners[i - 1] + (corners[i] - corners[i - 1]) * k / n;
      positions += fmt::format("{}[{:.2f},{:.2f},{:.2f}]", positions.empty() ? "" : ",", x.x(),
                               x.y(), x.z());
    }
  }
  return line_string("[" + positions + "]");
}

TEST(ReadLines, VerticesOnAStraightLineDoNotDivideIt) {
  // every coordinate is rounded to a hundredth
  const LineSet set =
      read("a.geojson",
           collection(feature("{}", dense({{0.11, 0.22, 5.33}, {12.02, 3.31, 7.17}}, 49)) + "," +
                      feature("{}", dense({{0, 0, 5}, {7.77, 1.13, 5.5}, {9.2, 8.1, 5}}, 31))));
  EXPECT_THAT(ids(set), ElementsAre("0", "1.0", "1.1"));
  EXPECT_EQ(set.lines[0].segment_in_world.end, Eigen::Vector3d(12.02, 3.31, 7.17));
  EXPECT_EQ(set.lines[1].segment_in_world.end, Eigen::Vector3d(7.77, 1.13, 5.5));
  EXPECT_THAT(set.warnings, ElementsAre("108 vertices within 0.02 of a straight line are ignored"));
}

TEST(ReadLines, ARingThatBeginsOnAnEdgeHasTheEdgesOfItsCorners) {
  const LineSet set = read(
      "a.geojson",
      collection(feature(
          "{}", dense({{3, 0, 5}, {8, 0, 5}, {8, 6, 5}, {0, 6, 5}, {0, 0, 5}, {3, 0, 5}}, 12))));
  ASSERT_EQ(set.lines.size(), 4U);
  EXPECT_EQ(set.lines[0].segment_in_world.start, Eigen::Vector3d(8, 0, 5));
  EXPECT_EQ(set.lines[3].segment_in_world.start, Eigen::Vector3d(0, 0, 5));
  EXPECT_EQ(set.lines[3].segment_in_world.end, Eigen::Vector3d(8, 0, 5));
}

TEST(ReadLines, BendsOfAFewCentimetresAndTurnsBackDivideALine) {
  const LineSet set = read(
      "a.geojson", collection(feature("{}", line_string("[[0,0,5],[6,0.03,5],[12,0,5]]")) + "," +
                              feature("{}", line_string("[[0,0,5],[6,0,5],[2,0,5]]")) + "," +
                              feature("{}", line_string("[[0,0,5],[6,0.01,5],[12,0,5]]"))));
  EXPECT_THAT(ids(set), ElementsAre("0.0", "0.1", "1.0", "1.1", "2"));
}

TEST(ReadLines, NamesTheFileAndTheRule) {
  EXPECT_THAT(io_error_of([] { read_lines("/nowhere/a.csv"); }), "/nowhere/a.csv: no such file");
  EXPECT_THAT(error_of("a.tif", "II*"),
              HasSubstr("extension '.tif': a TIFF image; supported are .geojson"));
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
              HasSubstr("a.csv:2: 'six' is not a number"));
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
              HasSubstr("a.csv: has no 3D lines but 1 point"));
  EXPECT_THAT(error_of("a.csv", "id,wkt\na,\"LINESTRING Z (1 2\"\n"), HasSubstr("is not WKT"));
}

TEST(ReadWkt, TakesOneGeometryARowAndTheSrid) {
  const LineSet set = read("a.wkt",
                           "LINESTRING Z (1 2 3, 4 5 6)\n"
                           "SRID=25832;LINESTRING Z (1 2 3, 4 5 6, 7 8 5)\n");
  EXPECT_THAT(ids(set), ElementsAre("0", "1.0", "1.1"));
  EXPECT_EQ(set.crs.definition, "EPSG:25832");
  EXPECT_EQ(set.format, "WKT");
}

TEST(ReadWkt, TakesTheSpellingsOfOtherPrograms) {
  for (const char* const text :
       {"LineStringZ (1 2 3, 4 5 6)", "LINESTRING Z(1 2 3,4 5 6)", "LINESTRINGZ(1 2 3,4 5 6)",
        "linestring z (1e0 2.0E+00 3, 4 5 6)", "LineStringZM(1 2 3 9, 4 5 6 9)",
        "LINESTRING(1 2 3,4 5 6)", "MultiLineStringZ ((1 2 3, 4 5 6))",
        "GEOMETRYCOLLECTION Z(POINTZ(0 0 0),LineStringZ(1 2 3, 4 5 6))",
        "SRID=25832;LINESTRINGZ(1 2 3, 4 5 6)"}) {
    SCOPED_TRACE(text);
    for (const LineSet& set :
         {read("a.wkt", text), read("a.csv", fmt::format("id;wkt\n7;\"{}\"\n", text))}) {
      ASSERT_EQ(set.lines.size(), 1U);
      EXPECT_EQ(set.lines[0].segment_in_world.start, Eigen::Vector3d(1, 2, 3));
      EXPECT_EQ(set.lines[0].segment_in_world.end, Eigen::Vector3d(4, 5, 6));
    }
  }
  EXPECT_THAT(error_of("a.wkt", "LineStringM (1 2 3, 4 5 6)"), HasSubstr("1 line without z"));
}

TEST(ReadCsv, TakesTheLayoutsOfOtherPrograms) {
  const std::string names = "x1,y1,z1,x2,y2,z2";
  const std::vector<std::string> texts{"# " + names + "\n1,2,3,4,5,6\n",
                                       "#" + names + "\n1 2 3 4 5 6\n",
                                       "# by NumPy\n# x1 y1 z1 x2 y2 z2\n1.0e0 2 3 4 5 6\n",
                                       "# a comment\n1 2 3 4 5 6\n",
                                       "//" + names + "\n1,2,3,4,5,6\n",
                                       std::string("sep=;\nx1;y1;z1;x2;y2;z2\n1;2;3;4;5;6\n"),
                                       "sep=,\r\n" + names + "\r\n1,2,3,4,5,6\r\n",
                                       "sep=\t\nx1\ty1\tz1\tx2\ty2\tz2\n1\t2\t3\t4\t5\t6\n",
                                       "\"a;b\"," + names + "\n\"c;d\",1,2,3,4,5,6\n",
                                       std::string("x1;y1;z1;x2;y2;z2\n1,0;2,0;3,0;4,0;5,0;6,0\n"),
                                       std::string("geometry\nLINESTRING Z (1 2 3, 4 5 6)\n"),
                                       std::string("id\tshape\n1\tLineStringZ (1 2 3, 4 5 6)\n")};
  for (const std::string& text : texts) {
    SCOPED_TRACE(text);
    const LineSet set = read("a.csv", text);
    ASSERT_EQ(set.lines.size(), 1U);
    EXPECT_EQ(set.lines[0].segment_in_world.start, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(set.lines[0].segment_in_world.end, Eigen::Vector3d(4, 5, 6));
  }
  EXPECT_THAT(error_of("a.csv", "# nothing\n# but comments\n"), HasSubstr("only comments"));
}

TEST(ReadWkt, RefusesASridThatIsNoCodeNamingTheRow) {
  EXPECT_THAT(error_of("a.wkt", "SRID=58x;LINESTRING Z (1 2 3, 4 5 6)\n"),
              HasSubstr("a.wkt:1: SRID '58x'"));
  EXPECT_THAT(error_of("a.wkt", "SRID=99999;LINESTRING Z (1 2 3, 4 5 6)\n"),
              HasSubstr("a.wkt: its reference system cannot be used"));
}

}  // namespace
}  // namespace ridgeline::io
