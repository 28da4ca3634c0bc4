// SPDX-License-Identifier: BSD-3-Clause
// What every reader says of a file of another kind.
#include "io/cloud/read_cloud.h"
#include "io/files/yaml_check.h"
#include "io/images/image.h"
#include "io/kinds/recognise.h"
#include "io/lines/read_lines.h"
#include "io/project/matches_file.h"
#include "io/project/patch.h"
#include "io/project/segments_file.h"
#include "tests/support/temp_folder.h"

namespace ridgeline::io {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kGates = "gates:\n  - {metric: rms_m, max: 1}\n";
constexpr const char* kMatches = "left_id,right_id\n0,0\n";
constexpr const char* kGeoJson = R"({"type":"FeatureCollection","features":[]})";

class Refusal : public testing::Test {
 protected:
  [[nodiscard]] std::string patch_error(const std::string& content) const {
    return io_error_of([&] { read_patch(folder_.write("file", content)); });
  }

  TempFolder folder_;
};

TEST_F(Refusal, OfAPatchFileNamesTheKindAndWhatTakesIt) {
  EXPECT_THAT(
      patch_error("LASF\1\2"),
      HasSubstr("file: is a LAS point cloud, not a patch file (patch.yaml); give it as `cloud`"));
  EXPECT_THAT(patch_error(kGates),
              HasSubstr("is a gates file, not a patch file (patch.yaml); give it as `gates`"));
  EXPECT_THAT(patch_error(kGeoJson), HasSubstr("is GeoJSON, not a patch file"));
  EXPECT_THAT(patch_error("PK\x03\x04"),
              HasSubstr("is a ZIP archive, unpack it; a patch file (patch.yaml) is expected"));
}

TEST_F(Refusal, LeavesTheReaderToNameLineAndRuleOfItsOwnKind) {
  EXPECT_THAT(patch_error("id: a\nimages: [\n"), HasSubstr("not YAML"));
  EXPECT_THAT(patch_error("id: a\nheight_range: [1, 2]\nimagess: []\n"),
              HasSubstr("line 3: unknown key 'imagess'"));
  EXPECT_THAT(patch_error(""), HasSubstr("is empty"));
  EXPECT_THAT(patch_error("some words\n"), HasSubstr("a mapping is expected"));
}

TEST_F(Refusal, OfEveryReaderNamesTheKind) {
  const std::string gates = folder_.write("gates.yaml", kGates);
  EXPECT_THAT(io_error_of([&] { read_lines(gates); }),
              HasSubstr("is a gates file, not a file of 3D lines; give it as `gates`"));
  const std::string as_text = folder_.write("gates.txt", kGates);
  EXPECT_THAT(io_error_of([&] { read_lines(as_text); }),
              HasSubstr("is a gates file, not a file of 3D lines"));
  EXPECT_THAT(io_error_of([&] { read_cloud({gates}); }),
              HasSubstr("is a gates file, not a point cloud"));
  EXPECT_THAT(io_error_of([&] { read_cloud({as_text}); }),
              HasSubstr("is a gates file, not a point cloud"));
  EXPECT_THAT(io_error_of([&] { image_facts(gates); }), HasSubstr("is a gates file, not an image"));
  EXPECT_THAT(io_error_of([&] { load_yaml(gates, FileGroup::kConfig); }),
              HasSubstr("is a gates file, not a config file"));
  EXPECT_THAT(io_error_of([&] { read_matches(gates); }),
              HasSubstr("is a gates file, not a table of matches"));
  EXPECT_THAT(io_error_of([&] { read_reference_matches(gates); }),
              HasSubstr("is a gates file, not a table of reference matches"));
  const std::string matches = folder_.write("matches.csv", kMatches);
  EXPECT_THAT(io_error_of([&] { read_segments(matches); }),
              HasSubstr("is a table of matches, not a table of segments"));
  EXPECT_THAT(io_error_of([&] { load_yaml(matches, FileGroup::kGates); }),
              HasSubstr("is a table of matches, not a gates file"));
}

TEST_F(Refusal, OfLinesUnderTheNameOfAnotherFormatSaysHowToNameThem) {
  const std::string file = folder_.write("a.gpkg", kGeoJson);
  EXPECT_THAT(
      io_error_of([&] { read_lines(file); }),
      HasSubstr("is GeoJSON, but its name does not match; use a name that ends in .geojson"));
  const std::string unnamed = folder_.write("a.out", "LINESTRING Z (1 2 3, 4 5 6)\n");
  EXPECT_THAT(io_error_of([&] { read_lines(unnamed); }), HasSubstr("use a name that ends in .wkt"));
}

TEST_F(Refusal, OfAFolderNamesWhatItHolds) {
  const std::string patch = folder_.write("one/patch.yaml", "");
  const std::string folder = folder_.file("one");
  EXPECT_THAT(io_error_of([&] { read_patch(folder); }), HasSubstr("give " + patch + " to run"));
  EXPECT_THAT(io_error_of([&] { read_cloud({folder}); }),
              HasSubstr("is not a regular file but a folder with a patch file"));
  EXPECT_THAT(io_error_of([&] { read_lines(folder); }),
              HasSubstr("is a folder with a patch file, not a file of 3D lines"));
  (void)folder_.write("two/a.las", "");
  EXPECT_THAT(io_error_of([&] { read_lines(folder_.file("two")); }),
              HasSubstr("is a folder with 1 cloud, without the track_K.txt of LIMAP"));
}

TEST_F(Refusal, OfANameAloneSaysSo) {
  const std::string file = folder_.write("a.kml", "no XML");
  EXPECT_THAT(io_error_of([&] { read_patch(file); }),
              AllOf(HasSubstr("is named as KML"), Not(HasSubstr(", not a patch"))));
}

}  // namespace
}  // namespace ridgeline::io
