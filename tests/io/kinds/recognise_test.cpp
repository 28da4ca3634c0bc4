// SPDX-License-Identifier: BSD-3-Clause
#include "io/kinds/recognise.h"

#include "tests/support/paths.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <string>
#include <utility>
#include <vector>

namespace ridgeline::io {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr const char* kHeader = "ply\nformat ascii 1.0\nelement vertex 2\n";

/// A content that begins with `start` and has `mark` at byte `at`.
std::string marked(std::size_t at, const std::string& start, const std::string& mark) {
  std::string content = start + std::string(500, '\0');
  return content.replace(at, mark.size(), mark);
}

TEST(KindOfContent, TellsBinaryFilesByTheirMarks) {
  const std::string las_with_laz_format = marked(104, "LASF", "\x86");
  for (const auto& [content, what] : std::vector<std::pair<std::string, std::string>>{
           {marked(104, "LASF", "\x06"), "a LAS point cloud"},
           {las_with_laz_format, "a LAZ point cloud"},
           {marked(377, "LASF", "copc"), "a COPC point cloud"},
           {"# .PCD v0.7\n", "a PCD point cloud"},
           {std::string("II*\0", 4) + "x", "a TIFF image"},
           {std::string("MM\0+", 4) + "x", "a TIFF image"},
           {"\x89PNG\r\n", "a PNG image"},
           {"\xFF\xD8\xFF\xE0", "a JPEG image"},
           {marked(68, std::string("SQLite format 3\0", 16), "GPKG"), "a GeoPackage"},
           {marked(68, std::string("SQLite format 3\0", 16), "MPBX"), "an SQLite database"},
           {std::string("\0\0\x27\x0A\0", 5), "a Shapefile"},
           {"PK\x03\x04 zip", "a ZIP archive"},
           {"\x1F\x8B\x08", "compressed with gzip"},
           {"%PDF-1.7", "a PDF"},
           {marked(257, "name", "ustar"), "a tar archive"},
           {std::string("\xFF\xFEx\0", 4), "text in UTF-16"},
           {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "a Git LFS pointer"}}) {
    const FileKind kind = kind_of_content(content, "a.yaml");
    EXPECT_EQ(kind.what, what);
    EXPECT_FALSE(kind.by_name) << what;
  }
}

TEST(KindOfContent, TellsOrientations) {
  for (const auto& [content, what] : std::vector<std::pair<std::string, std::string>>{
           {"filename,x,y,z,omega,phi,kappa\na,1,2,3,4,5,6\n", "omega, phi, kappa"},
           {"NOM\tX\tY\tZ\tO\tP\tK\tCAMERA\n", "omega, phi, kappa"},
           {"a b.tif 1 2 3 4 5 6\n", "omega, phi, kappa"},
           {"[ {\"cameras\": {\"c\": {\"projection_type\": \"brown\"}}}]", "OpenSfM"},
           {"fileName imageWidth imageHeight \ncamera matrix K [3x3]\n", "Pix4D"},
           {"$PROJECT 6.0.0\n$END\n", "Inpho project"},
           {"  17   1000.0 2000.0 300.0\n 1 0 0 0 1\n 0 0 0 1\n", "PAT-B"},
           {"<?xml version='1.0'?>\n<BlocksExchange version='3.2'>", "BlocksExchange"},
           {"<?xml version='1.0'?>\n<document version='2.0.0'><chunk label='a'>", "Metashape"}}) {
    const FileKind kind = kind_of_content(content, "a.txt");
    EXPECT_EQ(kind.group, FileGroup::kOrientation) << content;
    EXPECT_EQ(kind.what, "an orientation of images (" + what + ")");
  }
  EXPECT_EQ(kind_of_content("name lat lon alt roll pitch yaw\n", "a.csv").what,
            "a table of roll, pitch and yaw");
  // matrices of Pix4D and lines of numbers are no table of angles
  EXPECT_NE(kind_of_content("a.jpg 1 2 3 4 5 6 7 8 9 10 11 12\n", "a.txt").group,
            FileGroup::kOrientation);
  EXPECT_NE(kind_of_content("1 2 3 4 5 6 7\n8 9 1 2 3 4 5\n", "a.txt").group,
            FileGroup::kOrientation);
}

TEST(KindOfContent, TellsObjWithColoursFromOrientations) {
  for (const char* const vertices :
       {"v 1 2 3 0.5 0.4 0.3\nv 4 5 6 0.5 0.4 0.3\n", "v 1 2 3 128 116 100\nvn 0 0 1\n",
        "v 1 2 3 1\nv 4 5 6 1\n", "v\t1 2 3\nv\t4 5 6\n", "v 0 0 0 1\nv 0 1 0 1\nv 0 0 1 1\n"}) {
    for (const char* const before : {"", "####\n# of a tool\n####\n\n"}) {
      const std::string content = std::string(before) + vertices + "f 1 2 1\n";
      EXPECT_EQ(kind_of_content(content, "a.obj").what, "a mesh or lines (OBJ)") << content;
      EXPECT_FALSE(kind_of_content(content, "a.obj").by_name) << content;
    }
  }
  // images may be called "v" and "x"
  EXPECT_EQ(kind_of_content("v 1 2 3 4 5 6\nx 1 2 3 4 5 6\n", "a.txt").group,
            FileGroup::kOrientation);
  EXPECT_EQ(kind_of_content("v 1 2 3\n1 0 0 0 1\n0 0 0 1\n", "a.txt").group,
            FileGroup::kOrientation);
}

TEST(KindOfContent, TellsTextsByTheirFirstRows) {
  for (const auto& [content, what] : std::vector<std::pair<std::string, std::string>>{
           {R"({"type":"FeatureCollection","features":[]})", "GeoJSON"},
           {"\xEF\xBB\xBF{\"type\":\"LineString\"}", "GeoJSON"},
           {R"({"CityObjects":{},"type":"CityJSON"})", "a building model (CityJSON)"},
           {"{\"type\":\"CityJSON\"}\n{\"type\":\"CityJSONFeature\"}\n",
            "a building model (CityJSON)"},
           {R"({"type":"CityJSONFeature"})", "a CityJSON feature"},
           {R"({"type":"Topology"})", "TopoJSON"},
           {R"({"asset":{},"meshes":[]})", "glTF, a mesh for display"},
           {"  0\nSECTION\n", "a DXF drawing"},
           {"# of a tool\nmtllib a.mtl\nv 1 2 3\n", "a mesh or lines (OBJ)"},
           {"LINESTRING Z (1 2 3, 4 5 6)\n", "lines as WKT"},
           {"id;geometry\n1;\"LineStringZ (1 2 3, 4 5 6)\"\n", "lines as WKT"},
           {"ID,X1,Y1,Z1,X2,Y2,Z2,left_id,right_id\n", "a CSV of 3D lines"},
           {"1 2 3\n4 5 6\n", "text with numbers, such as a point cloud or lines"},
           {"2\n1 2 3\n4 5 6\n", "text with numbers, such as a point cloud or lines"},
           {"\"X\";\"Y\";\"Z\"\n1,5;2;3\n", "text with numbers, such as a point cloud or lines"},
           {"<?xml version='1.0'?><CityModel/>", "a building model (CityGML)"},
           {"<kml>", "KML, whose coordinates are degrees"},
           {"<!DOCTYPE html><p>404", "a web page"},
           {std::string(kHeader) + "element face 1\nend_header\n", "a mesh (PLY)"},
           {std::string(kHeader) + "element edge 1\nend_header\n", "lines (PLY)"},
           {std::string(kHeader) + "end_header\nelement edge 1\n", "a PLY point cloud"}}) {
    EXPECT_EQ(kind_of_content(content, "a.yaml").what, what) << content;
  }
}

TEST(KindOfContent, TellsTheFilesOfTheProgramItself) {
  for (const auto& [content, group] : std::vector<std::pair<std::string, FileGroup>>{
           {"id: a\nheight_range: [1, 2]\nimages:\n  - id: left\n", FileGroup::kPatch},
           {R"({"id": "a", "height_range": [1, 2], "colmap": "sparse/0"})", FileGroup::kPatch},
           {"gates:\n  - {metric: rms_m, max: 1}\n", FileGroup::kGates},
           {"judge:\n  seed: 1\n", FileGroup::kConfig},
           {"left_id,right_id,score,votes,matcher\n0,0,1,1,pairwise\n", FileGroup::kMatches},
           {"id,kind,left_x1_px,right_x1_px\n", FileGroup::kReferenceMatches},
           {"id,x1_px,y1_px,x2_px,y2_px\n0,1,2,3,4\n", FileGroup::kSegments},
           {R"({"patch":"1","method":"joint","origin_m":[)", FileGroup::kEvaluation},
           {R"({"command":"run","versions":{)", FileGroup::kResult},
           {"patch,method,class,n_lines\n", FileGroup::kResult},
           {"<!doctype html>\n<meta name=\"generator\" content=\"ridgeline\">",
            FileGroup::kResult}}) {
    EXPECT_EQ(kind_of_content(content, "a.dat").group, group) << content;
  }
}

TEST(KindOfContent, LeavesOpenWhatHasKeysOfTwoKinds) {
  EXPECT_FALSE(kind_of_content("gates: []\njudge: {}\n", "a.yaml").is_known());
  const std::string patch_with_a_wrong_key = "images: []\nheight_range: [1, 2]\ngates: []\n";
  EXPECT_EQ(kind_of_content(patch_with_a_wrong_key, "a.yaml").group, FileGroup::kPatch);
}

TEST(KindOfContent, OfGeoJsonMayHaveItsTypeFarOff) {
  const std::string lines = R"({"crs":null,"features":[{"geometry":{"type":"LineString"}}],"x":")" +
                            std::string(2 * kTelling_bytes, ' ') +
                            R"(","type":"FeatureCollection"})";
  EXPECT_EQ(kind_of_content(lines, "a.json").what, "GeoJSON");
}

TEST(KindOfContent, OfAHeaderAloneTellsWktFromMatches) {
  EXPECT_EQ(kind_of_content("WKT,id,left_id,right_id\n", "a.csv").group, FileGroup::kLines);
  EXPECT_EQ(kind_of_content("id,left_id,right_id\n", "a.csv").group, FileGroup::kMatches);
}

TEST(KindOfContent, FallsBackOnTheName) {
  const FileKind kind = kind_of_content("what?", "dir.x/cloud.LAZ");
  EXPECT_EQ(kind.what, "a LAZ point cloud");
  EXPECT_TRUE(kind.by_name);
  EXPECT_FALSE(kind_of_content("what?", "a.unheard").is_known());
  EXPECT_EQ(kind_of_content("", "cloud.laz").group, FileGroup::kEmpty);
}

TEST(KindOfContent, TellsTheIndexOfAShapefileByItsName) {
  const std::string start("\0\0\x27\x0A\0", 5);
  const FileKind kind = kind_of_content(start, "a.shx");
  EXPECT_EQ(kind.what, "the index of a Shapefile");
  EXPECT_EQ(kind.advice, "give the .shp");
}

TEST(KindOfContent, TellsASequenceOfGeoJsonByItsName) {
  const FileKind kind = kind_of_content("{\"type\":\"Feature\"}\n", "a.geojsonl");
  EXPECT_EQ(kind.what, "a sequence of JSON texts");
  EXPECT_FALSE(kind.by_name);
}

TEST(BeginningOf, AHugeFileIsNoMoreThanItsFirstBytes) {
  const TempFolder folder;
  const std::string file = folder.write("a.las", "LASF");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40U);  // the file is sparse
  EXPECT_THAT(beginning_of(file), SizeIs(kTelling_bytes));
  EXPECT_THAT(io_error_of([&] { require_kind(file, FileGroup::kPatch); }),
              HasSubstr("is a LAS point cloud, not a patch file"));
}

TEST(BeginningOf, APipeIsNotOpened) {
  const TempFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(beginning_of(pipe), "");
  EXPECT_FALSE(kind_of_path(pipe).is_known());
}

}  // namespace
}  // namespace ridgeline::io
