// SPDX-License-Identifier: BSD-3-Clause
// Results of other tools: OBJ and PLY models, Line3D++, LIMAP, ELSR; Shapefile and DXF.
#include "io/gdal/geopackage_writer.h"
#include "io/lines/line_facts.h"
#include "io/lines/read_lines.h"
#include "tests/support/paths.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

namespace ridgeline::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const ReadLinesOptions kToolDefaults;
const std::string kShared = test::shared_data_dir();

LineSet read_tool(std::string_view name,
                  std::string_view content,
                  const ReadLinesOptions& options = kToolDefaults) {
  const TempFolder folder;
  return read_lines(folder.write(name, content), options);
}

std::string tool_error_of(std::string_view name, std::string_view content) {
  const TempFolder folder;
  const std::string path = folder.write(name, content);
  return io_error_of([&] { read_lines(path); });
}

std::vector<std::string> tool_ids(const LineSet& set) {
  std::vector<std::string> result;
  for (const Line& line : set.lines) result.push_back(line.id);
  return result;
}

TEST(ReadObj, FollowsPolylinesWithEveryKindOfIndex) {
  const LineSet set = read_tool("a.obj",
                                "# comment\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 1 1 1\n"
                                "l 1 2 \\\n 3/7\nl -2 -1 # to the last\n");
  EXPECT_THAT(tool_ids(set), ElementsAre("0.0", "0.1", "1"));
  EXPECT_EQ(set.lines[1].segment_in_world.end, Eigen::Vector3d(1, 1, 0));
  EXPECT_EQ(set.lines[2].segment_in_world.start, Eigen::Vector3d(1, 1, 0));
  EXPECT_EQ(set.lines[2].segment_in_world.end, Eigen::Vector3d(1, 1, 1));
}

TEST(ReadObj, TakesEachEdgeOfTheFacesOnce) {
  // Two triangles with a common edge, the second with vertices of its own.
  const LineSet set = read_tool("a.obj",
                                "v 0 0 0\nv 1 0 0\nv 0 1 1\nv 0 1 1\nv 1 0 0\nv 2 2 2\n"
                                "f 1//1 2//1 3//1\nf 4 5 6\n");
  EXPECT_EQ(set.lines.size(), 5U);
  EXPECT_EQ(set.format, "OBJ, edges of faces");
}

TEST(ReadObj, PrefersLinesUnlessTheyOnlyRepeatTheFaces) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3 4\n";
  EXPECT_EQ(read_tool("a.obj", square + "l 1 3\n").lines.size(), 1U);
  EXPECT_EQ(read_tool("a.obj", square + "l 1 2 3 4\n").lines.size(), 4U);  // with the closing edge
}

TEST(ReadObj, ReadsElsrVerticesTwoByTwo) {
  std::string obj;
  for (int i = 0; i < 5; ++i) {
    obj += "v " + std::to_string(i) + " 0 0\nv " + std::to_string(i) + " 1 0.5\n";
  }
  obj += "v nan 0 0\nv 1 1 1\nv 0 0 0\nv 0 0 1e9\nl 3 4\nl 5 6\nl 7 8\n";
  const LineSet set = read_tool("a.obj", obj);
  EXPECT_THAT(tool_ids(set), ElementsAre("0", "1", "2", "3", "4"));
  EXPECT_EQ(set.lines[1].segment_in_world.end, Eigen::Vector3d(1, 1, 0.5));
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("wrong index"), HasSubstr("2 segments dropped")));
}

TEST(ReadObj, AsksBeforeItPairsVertices) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\n";
  EXPECT_THAT(tool_error_of("a.obj", obj), HasSubstr("`pairs`"));
  EXPECT_EQ(read_tool("a.obj", obj, {.assume_crs = {}, .vertex_pairs = true}).lines.size(), 2U);
}

TEST(ReadObj, NamesTheRowThatIsWrong) {
  EXPECT_THAT(tool_error_of("a.obj", "v 0 0 0\nl 1 2\n"),
              HasSubstr("a.obj:2: vertex index 2, but the file"));
  EXPECT_THAT(tool_error_of("a.obj", "v 0 0\n"),
              HasSubstr("a.obj:1: a vertex must have three coordinates"));
  EXPECT_THAT(tool_error_of("a.obj", "v 0 0 x\n"), HasSubstr("a.obj:1: 'x' is not a number"));
  EXPECT_THAT(tool_error_of("a.obj", "v 0 0 0\nl 0 1\n"), HasSubstr("a.obj:2: vertex index '0'"));
}

TEST(ReadObj, ReadsRoofModels) {
  const std::string folder = kShared + "/point2roof/roof1";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  // 7 vertices and 6 faces of a closed cap: E = V + F - 1.
  EXPECT_EQ(read_lines(folder + "/ground_truth.obj").lines.size(), 12U);
  EXPECT_EQ(read_lines(folder + "/Point2Roof.obj").lines.size(), 12U);
  EXPECT_EQ(read_lines(folder + "/2D_dual_contouring.obj").format, "OBJ, edges of faces");
  const LineSet topolap = read_lines(folder + "/TopoLAP.obj");
  EXPECT_EQ(topolap.format, "OBJ, edges of roofs");  // it has walls
  EXPECT_GT(topolap.lines.size(), 40U);
}

TEST(ReadObj, ObjectsOfAMeshWithWallsAreItsBuildings) {
  // Two sheds side by side; a record of two vertices is no face.
  std::string obj;
  for (const int x : {0, 5}) {
    for (const char* const yz : {"0 0", "4 0", "0 3", "4 5"})
      obj += "v " + std::to_string(x) + " " + yz + "\nv " + std::to_string(x + 4) + " " + yz + "\n";
  }
  obj += "o A\nf 1 2\nf 5 6 8 7\nf 1 2 6 5\no B\nf 13 14 16 15\nf 9 10 14 13\n";
  const LineSet set = read_tool("sheds.obj", obj);
  ASSERT_TRUE(set.model);
  ASSERT_EQ(set.model->buildings.size(), 2U);
  EXPECT_EQ(set.model->buildings[1].id, "B");
  EXPECT_EQ(set.lines.size(), 8U);
  EXPECT_THAT(set.left_out.text(), HasSubstr("1 face without an area"));
}

std::string binary_ply(bool big_endian) {
  std::string ply = "ply\nformat binary_" + std::string(big_endian ? "big" : "little") +
                    "_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                    "property double z\nelement edge 2\nproperty int vertex1\n"
                    "property uchar red\nproperty int vertex2\nend_header\n";
  const auto append = [&](auto value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big_endian) bytes.assign(bytes.rbegin(), bytes.rend());
    ply += bytes;
  };
  for (int i = 0; i < 3; ++i) {
    append(static_cast<float>(i));
    append(2.5F);
    append(10.0 + i);
  }
  for (int i = 0; i < 2; ++i) {
    append(i);
    append(static_cast<unsigned char>(200));
    append(i + 1);
  }
  return ply;
}

TEST(ReadPly, ReadsBinaryEdgesOfEitherByteOrder) {
  for (const bool big_endian : {false, true}) {
    const LineSet set = read_tool("a.ply", binary_ply(big_endian));
    ASSERT_EQ(set.lines.size(), 2U);
    EXPECT_EQ(set.lines[1].segment_in_world.start, Eigen::Vector3d(1.0, 2.5, 11.0));
    EXPECT_EQ(set.lines[1].segment_in_world.end, Eigen::Vector3d(2.0, 2.5, 12.0));
  }
}

TEST(ReadPly, TakesTheEdgesOfFacesWithoutEdges) {
  const LineSet set = read_tool("a.ply",
                                "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                                "property float y\nproperty float z\nelement face 2\n"
                                "property list uchar int vertex_indices\nend_header\n"
                                "0 0 0\n1 0 0\n1 1 1\n0 1 1\n3 0 1 2\n3 0 2 3\n");
  EXPECT_EQ(set.lines.size(), 5U);
}

TEST(ReadPly, SaysWhatIsWrong) {
  std::string ply = binary_ply(false);
  ply.resize(ply.size() - 3);
  EXPECT_THAT(tool_error_of("a.ply", ply), HasSubstr("ends before the elements"));
  EXPECT_THAT(tool_error_of("a.ply", "obj\n"), HasSubstr("a.ply: line 1: must be \"ply\""));
  const std::string head = "ply\nformat ascii 1.0\nelement edge 1\nproperty int vertex1\n";
  EXPECT_THAT(tool_error_of("a.ply", head + "property int vertex2\nend_header\n0 7\n"),
              HasSubstr("refers to a vertex beyond the 0 vertices"));
  EXPECT_THAT(tool_error_of("a.ply", head + "property quad vertex2\nend_header\n0 7\n"),
              HasSubstr("a.ply: line 5: \"quad\" is not a PLY type"));
  EXPECT_THAT(
      tool_error_of("a.ply", "ply\nformat ascii 1.0\nelement edge 99999999999\nend_header\n"),
      HasSubstr("edge has no properties"));
}

std::string ply_with_edges(const std::string& properties, const std::string& edges) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
         "float "
         "z\nelement edge 2\n" +
         properties + "end_header\n0 0 0\n1 0 0\n1 1 1\n" + edges;
}

TEST(ReadPly, TakesTheEndsOfEdgesUnderAnyNamesWhereNothingElseMayBeMeant) {
  for (const auto& [properties, edges] :
       {std::pair("property int start\nproperty int end\n", "0 1\n1 2\n"),
        std::pair("property uint a\nproperty uchar red\nproperty uint b\n", "0 255 1\n1 0 2\n"),
        std::pair("property list uchar int vertex_indices\n", "2 0 1\n2 1 2\n")}) {
    SCOPED_TRACE(properties);
    const LineSet set = read_tool("a.ply", ply_with_edges(properties, edges));
    ASSERT_EQ(set.lines.size(), 2U);
    EXPECT_EQ(set.lines[1].segment_in_world.start, Eigen::Vector3d(1, 0, 0));
    EXPECT_EQ(set.lines[1].segment_in_world.end, Eigen::Vector3d(1, 1, 1));
  }
}

TEST(ReadPly, NamesThePropertiesWhereOthersAreExpected) {
  EXPECT_THAT(
      tool_error_of("a.ply", ply_with_edges("property int a\nproperty int b\nproperty int c\n",
                                            "0 1 2\n1 2 0\n")),
      HasSubstr("element edge has the properties a, b, c; vertex1 and vertex2"));
  EXPECT_THAT(
      tool_error_of("a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                    "property float height\nend_header\n0 0 0\n"),
      HasSubstr("element vertex has the properties x, y, height; x, y and z are expected"));
  EXPECT_THAT(
      tool_error_of("a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                    "property float z\nend_header\n0 0 0\n"),
      HasSubstr("has no 3D lines but 1 vertex"));
}

TEST(ReadLine3dpp, ReadsAllSegmentsOfALineAndCountsImages) {
  const LineSet set = read_tool("lines.txt",
                                "2 0 0 0 1 0 0 5 0 0 6 0 1 3 7 0 1 2 3 4 8 1 1 2 3 4 7 5 1 2 3 4 \n"
                                "1 0 0 0 1 1 1 1 7 0 1 2 3 4 \n");
  EXPECT_THAT(tool_ids(set), ElementsAre("0.0", "0.1", "1"));
  EXPECT_EQ(set.lines[1].parent_id, "0");
  EXPECT_EQ(set.lines[1].segment_in_world.end, Eigen::Vector3d(6, 0, 1));
  EXPECT_EQ(set.lines[0].n_images, 2);
  EXPECT_EQ(set.format, "Line3D++");
}

TEST(ReadLine3dpp, WarnsOfCoordinatesThatSixDigitsCannotHold) {
  const LineSet set =
      read_tool("a.txt", "1 513021 5.40312e+06 250 513022 5.40312e+06 251 1 7 0 1 2 3 4\n");
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("six digits")));
}

TEST(ReadLine3dpp, NamesTheRowThatIsTruncated) {
  EXPECT_THAT(tool_error_of("a.txt", "1 0 0 0 1 1 1 1 7 0 1 2 3 4\n2 0 0 0 1 1 1 1\n"),
              HasSubstr("a.txt:2: word 14 is not a count"));
  EXPECT_THAT(tool_error_of("a.txt", "1 0 0 0 1 1 1 2 7 0 1 2 3 4\n"),
              HasSubstr("a.txt:1: 14 fields; 20 are expected"));
}

TEST(ReadLine3dpp, AgreesWithTheObjBesideIt) {
  const std::string folder = kShared + "/line3dpp";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const LineSet text = read_lines(folder + "/lines.txt");
  const LineSet obj = read_lines(folder + "/lines.obj");
  ASSERT_EQ(text.lines.size(), 864U);
  ASSERT_EQ(obj.lines.size(), 864U);
  EXPECT_THAT(text.warnings, IsEmpty());
  for (std::size_t i = 0; i < obj.lines.size(); ++i) {
    EXPECT_EQ(text.lines[i].segment_in_world.start, obj.lines[i].segment_in_world.start);
    EXPECT_EQ(text.lines[i].segment_in_world.end, obj.lines[i].segment_in_world.end);
  }
}

TEST(ReadLimap, ReadsTracks) {
  const std::string tracks =
      "2\n5 4 3\n0 0 0\n1 2 3\n1 2 2 3\n0 0 1 2\n8 4 4\n1 0 0\n1 2 9\n1 2 3 4\n0 0 1 2\n";
  const LineSet set = read_tool("alltracks.txt", tracks);
  EXPECT_THAT(tool_ids(set), ElementsAre("5", "8"));
  EXPECT_EQ(set.lines[0].n_images, 3);
  EXPECT_EQ(set.lines[1].segment_in_world.end, Eigen::Vector3d(1, 2, 9));
  EXPECT_THAT(tool_error_of("a.txt", tracks.substr(0, tracks.size() - 8)),
              HasSubstr("ends before"));
  EXPECT_THAT(tool_error_of("a.txt", tracks + "1 2 3\n"),
              HasSubstr("a.txt:12: continues after the 2"));
}

TEST(ReadLimap, ReadsAFolderOfTracksInTheirOrder) {
  const TempFolder folder;
  const std::string rest =
      "2 2\nimage_id_list 4 9\nline_id_list 0 1\nline2d_list\n1 2 3 4\n1 2 3 4\nEND\n";
  for (const int k : {10, 2}) {
    const std::string name = "tracks/track_" + std::to_string(k) + ".txt";
    (void)folder.write(name, std::to_string(k) + " 0 0 1 1 1\n" + rest);
  }
  const LineSet set = read_lines(folder.file("tracks"));
  EXPECT_THAT(tool_ids(set), ElementsAre("2", "10"));
  EXPECT_EQ(set.lines[1].segment_in_world.start.x(), 10.0);
  EXPECT_EQ(set.lines[0].n_images, 2);
  (void)folder.write("empty/readme.md", "");
  EXPECT_THAT(io_error_of([&] { read_lines(folder.file("empty")); }),
              HasSubstr("without the track_K.txt of LIMAP"));
  (void)folder.write("v2/structures/x", "");
  EXPECT_THAT(io_error_of([&] { read_lines(folder.file("v2")); }), HasSubstr("LIMAP 2.0"));
}

TEST(ReadElsr, ReadsSpaceLinesAndTheCamerasBesideThem) {
  const TempFolder folder;
  (void)folder.write("cams.txt", "1 2 5\n2 5\n");
  const LineSet set = read_lines(folder.write("spaceLines.txt", "0 0 0 1 1 1\n0 0 0 2 2 2\n"));
  ASSERT_EQ(set.lines.size(), 2U);
  EXPECT_EQ(set.lines[0].n_images, 3);
  EXPECT_EQ(set.lines[1].n_images, 2);
  EXPECT_THAT(tool_error_of("a.txt", "0 0 0 1 1 1\n0 0 0 2 2\n"),
              HasSubstr("a.txt:2: 5 fields; 6 are expected"));
}

TEST(ReadShapefile, RefusesTypesWithoutHeight) {
  std::string header(100, '\0');
  header[2] = 0x27;
  header[3] = 0x0a;
  header[32] = 3;
  EXPECT_THAT(tool_error_of("a.shp", header), HasSubstr("a.shp: shape type 3 (PolyLine) has no z"));
  header[32] = 23;
  EXPECT_THAT(tool_error_of("a.shp", header),
              HasSubstr("a.shp: shape type 23 (PolyLineM) has no z"));
  EXPECT_THAT(tool_error_of("a.shp", "PK"), HasSubstr("shorter than its header"));
}

TEST(ReadOgr, SaysWhatIsWrong) {
  EXPECT_THAT(tool_error_of("a.gpkg", "SQLite? no"), HasSubstr("a.gpkg: is not a GeoPackage"));
  EXPECT_THAT(tool_error_of("a.gpkg", ""), HasSubstr("a.gpkg: is empty"));
  EXPECT_THAT(tool_error_of("a.dxf", "\x01\x02\x03"), HasSubstr("a.dxf: is not a DXF"));
  EXPECT_THAT(io_error_of([] { read_lines("/nowhere/a.dxf"); }), HasSubstr("no such file"));
}

TEST(ReadOgr, CountsWhatALevelThatIsNotReadHasInAddition) {
  const auto layer = [](const char* name, int n_buildings) {
    MapLayer made{.name = name,
                  .description = "",
                  .geometry = MapGeometry::kMultiPolygon,
                  .columns = {},
                  .features = {},
                  .style = {}};
    for (int i = 0; i < n_buildings; ++i) {
      const double x = 20.0 * i;
      MapFeature& building = made.features.emplace_back();
      building.polygons = {{{{x, 0, 5}, {x + 8, 0, 5}, {x + 8, 8, 5}, {x, 8, 5}}},
                           {{{x, 0, 0}, {x + 8, 0, 0}, {x + 8, 0, 5}, {x, 0, 5}}}};
    }
    return made;
  };
  const TempFolder folder;
  write_geopackage(folder.file("a.gpkg"), {"EPSG:25832"},
                   {layer("lod12_3d", 2), layer("lod13_3d", 3), layer("lod22_3d", 2)});
  const LineSet set = read_lines(folder.file("a.gpkg"));
  EXPECT_EQ(set.model->buildings.size(), 2U);
  EXPECT_THAT(set.warnings,
              ElementsAre("reading layer lod22_3d; ignored: lod12_3d, lod13_3d (1 feature more)"));
}

TEST(ReadDxf, TakesTheLayerAsTheClass) {
  const LineSet set =
      read_tool("a.dxf",
                "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nRIDGES\n10\n1.5\n20\n2\n30\n3\n"
                "11\n4\n21\n5\n31\n6.25\n0\nENDSEC\n0\nEOF\n");
  ASSERT_EQ(set.lines.size(), 1U);
  EXPECT_EQ(set.lines[0].line_class, "RIDGES");
  EXPECT_EQ(set.lines[0].segment_in_world.start, Eigen::Vector3d(1.5, 2, 3));
  EXPECT_EQ(set.lines[0].segment_in_world.end, Eigen::Vector3d(4, 5, 6.25));
}

/// A line on each layer; OLD is frozen, HID is off.
std::string dxf_of_layers(const std::string& insunits) {
  std::string dxf =
      "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + insunits +
      "\n9\n$LUNITS\n70\n2\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n3\n";
  const auto add = [&dxf](const char* text) { dxf += text; };
  add("0\nLAYER\n2\nRIDGES\n70\n0\n62\n7\n6\nCONTINUOUS\n");
  add("0\nLAYER\n2\nOLD\n70\n1\n62\n7\n6\nCONTINUOUS\n");
  add("0\nLAYER\n2\nHID\n70\n0\n62\n-7\n6\nCONTINUOUS\n0\nENDTAB\n0\nENDSEC\n");
  add("0\nSECTION\n2\nENTITIES\n");
  for (const char* const layer : {"RIDGES", "OLD", "HID"}) {
    dxf +=
        std::string("0\nLINE\n8\n") + layer + "\n10\n1.5\n20\n2\n30\n3\n11\n4\n21\n5\n31\n6.25\n";
  }
  return dxf + "0\nENDSEC\n0\nEOF\n";
}

TEST(ReadDxf, LeavesHiddenLayersOutAndCountsThem) {
  const LineSet set = read_tool("a.dxf", dxf_of_layers("6"));
  ASSERT_EQ(set.lines.size(), 1U);
  EXPECT_EQ(set.lines[0].line_class, "RIDGES");
  EXPECT_THAT(set.warnings, ElementsAre("ignored: 2 entities of hidden layers"));
  EXPECT_EQ(set.stated_unit, "");
}

TEST(ReadDxf, KnowsTheUnitThatTheHeaderStates) {
  EXPECT_EQ(read_tool("a.dxf", dxf_of_layers("4")).stated_unit, "millimetres");
  EXPECT_EQ(read_tool("a.dxf", dxf_of_layers("1")).stated_unit, "inches");
}

TEST(LineFactsOf, CountsWhatTheSetHolds) {
  const LineFacts facts = line_facts(read_tool("a.csv",
                                               "id,method,wkt\n"
                                               "a,joint,\"LINESTRING Z (0 0 0,3 4 0,3 4 12)\"\n"
                                               "b,,\n"
                                               "c,,\"LINESTRING Z (-1 0 0,-1 0 1)\"\n"));
  EXPECT_EQ(facts.n_lines, 4U);
  EXPECT_EQ(facts.n_polylines, 1U);
  EXPECT_EQ(facts.n_non_finite, 1U);
  EXPECT_DOUBLE_EQ(facts.total_length, 5.0 + 12.0 + 1.0);
  EXPECT_EQ(facts.bounds.min(), Eigen::Vector3d(-1, 0, 0));
  EXPECT_EQ(facts.bounds.max(), Eigen::Vector3d(3, 4, 12));
  EXPECT_THAT(facts.attributes, ElementsAre("id", "parent_id", "method"));
  EXPECT_TRUE(line_facts({}).bounds.isEmpty());
}

}  // namespace
}  // namespace ridgeline::io
