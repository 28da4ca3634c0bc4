// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/patch.h"

#include "tests/support/paths.h"
#include "tests/support/temp_folder.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace ridgeline::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kPatchPixelTolerance = 1e-6;

constexpr const char* kPatch = R"(id: "1"
crs: "EPSG:25832+7837"
height_range: [250, 300]
images:
  - id: left
    path: images/left.tif
    projection_matrix:
      - [1000.0, 0.0, -512.0, 409600.0]
      - [0.0, -1000.0, -512.0, 409600.0]
      - [0.0, 0.0, -1.0, 800.0]
  - id: right
    path: right.tif
    interior: {focal_length_mm: 120, pixel_size_um: 12, size_px: [7680, 13824], principal_point_mm: [0, 0], k1: 0.01}
    exterior: {position_m: [513000, 5403000, 1500], omega_phi_kappa_deg: [0, 0, 90]}
    window_px: [3000, 6000]
lidar: [lidar.las, "tiles/*.laz"]
reference_matches: matches.csv
reference_tracks: tracks.csv
reference_lines: /data/truth.geojson
)";

/// kPatch with the first match of `what` replaced.
std::string patch_with(const std::string& what, const std::string& replacement) {
  const std::string text = kPatch;
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.substr(0, at) + replacement + text.substr(at + what.size());
}

std::string error_of(const std::string& yaml) {
  const TempFolder folder;
  const std::string path = folder.write("patch.yaml", yaml);
  return io_error_of([&] { read_patch(path); });
}

TEST(ReadPatch, ResolvesPathsAgainstTheFile) {
  const TempFolder folder;
  const PatchFile patch = read_patch(folder.write("patch.yaml", kPatch));
  EXPECT_EQ(patch.id, "1");
  EXPECT_EQ(patch.crs.definition, "EPSG:25832+7837");
  EXPECT_THAT(patch.height_range_m.value(), ElementsAre(250.0, 300.0));
  ASSERT_EQ(patch.images.size(), 2U);
  EXPECT_EQ(patch.images[0].id, "left");
  EXPECT_EQ(patch.images[0].path, folder.file("images/left.tif"));
  EXPECT_THAT(patch.lidar, ElementsAre(folder.file("lidar.las"), folder.file("tiles/*.laz")));
  EXPECT_EQ(patch.reference_matches, folder.file("matches.csv"));
  EXPECT_EQ(patch.reference_tracks, folder.file("tracks.csv"));
  EXPECT_EQ(patch.reference_lines, "/data/truth.geojson");
}

TEST(ReadPatch, TakesTheMatrixAsItStands) {
  const TempFolder folder;
  const PatchFile patch = read_patch(folder.write("patch.yaml", kPatch));
  ProjectionMatrix expected;
  expected << 1000, 0, -512, 409600, 0, -1000, -512, 409600, 0, 0, -1, 800;
  EXPECT_EQ(patch.images[0].image_from_world, expected);
  EXPECT_FALSE(patch.images[0].interior.has_value());
}

TEST(ReadPatch, MakesTheMatrixOfTheWindowFromTheOrientation) {
  const TempFolder folder;
  const PatchFile patch = read_patch(folder.write("patch.yaml", kPatch));
  // kappa = 90 deg: image columns run north, rows run east. 1000 m below, 0.1 m is one pixel.
  const Eigen::Vector3d x(513000.0 + 30.0, 5403000.0 + 20.0, 500.0);
  const Eigen::Vector2d expected(3839.5 + 200.0 - 3000.0, 6911.5 + 300.0 - 6000.0);
  EXPECT_LT((project(patch.images[1].image_from_world, x) - expected).norm(), kPatchPixelTolerance);
}

TEST(ReadPatch, TakesAnInteriorOrientationInPixels) {
  const TempFolder folder;
  const auto in_mm = read_patch(folder.write("patch.yaml", kPatch)).images[1];
  const auto in_px =
      read_patch(folder.write("px.yaml",
                              patch_with("focal_length_mm: 120, pixel_size_um: 12, size_px: [7680, "
                                         "13824], principal_point_mm: [0, 0]",
                                         "focal_length_px: [10000, 10000], size_px: [7680, 13824], "
                                         "principal_point_px: [3839.5, 6911.5]")))
          .images[1];
  EXPECT_TRUE(in_px.image_from_world.isApprox(in_mm.image_from_world, 1e-14));
  EXPECT_EQ(in_px.interior->distortion.k1, 0.01);
  EXPECT_THAT(error_of(patch_with("pixel_size_um: 12", "focal_length_px: [10000, 10000]")),
              HasSubstr("focal_length_mm cannot be combined with focal_length_px"));
  EXPECT_THAT(error_of(patch_with("principal_point_mm: [0, 0]", "principal_point_px: [0, 0]")),
              HasSubstr("principal_point_px requires focal_length_px"));
  EXPECT_THAT(error_of(patch_with(
                  "focal_length_mm: 120, pixel_size_um: 12, size_px: [7680, 13824], "
                  "principal_point_mm: [0, 0]",
                  "focal_length_px: [-1, 1], size_px: [7680, 13824], principal_point_px: [0, 0]")),
              HasSubstr("must be above 0"));
}

TEST(ReadPatch, RemovesTheDistortionInPixelsOfTheWindow) {
  const TempFolder folder;
  const PatchFile patch = read_patch(folder.write("patch.yaml", kPatch));
  const PatchImage& image = patch.images[1];
  ASSERT_TRUE(image.interior.has_value());
  const Eigen::Vector2d ideal(100.0, 100.0);
  const Eigen::Vector2d observed =
      distorted_px(*image.interior, ideal + image.window_px) - image.window_px;
  EXPECT_GT((observed - ideal).norm(), 0.1);
  const auto actual = undistorted_px(image, observed);
  ASSERT_TRUE(actual.has_value());
  EXPECT_LT((*actual - ideal).norm(), kPatchPixelTolerance);
  EXPECT_EQ(undistorted_px(patch.images[0], observed), observed);
}

TEST(ReadPatch, TakesJson) {
  const TempFolder folder;
  const PatchFile patch = read_patch(folder.write("patch.json", R"({
    "id": 7, "height_range": [0, 10], "images": [
      {"id": 0, "path": "a.png", "projection_matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,0]]},
      {"id": 1, "path": "b.png", "projection_matrix": [[1,0,0,-1],[0,1,0,0],[0,0,1,0]]}]})"));
  EXPECT_EQ(patch.id, "7");
  EXPECT_FALSE(patch.crs.known());
  EXPECT_TRUE(patch.lidar.empty());
}

TEST(ReadPatch, NamesUnknownKeysWithTheirLine) {
  EXPECT_THAT(
      error_of(patch_with("lidar:", "lidra:")),
      HasSubstr(
          "patch.yaml: line 16: unknown key 'lidra', did you mean 'lidar'? known keys: id, crs, "));
  EXPECT_THAT(error_of(patch_with("path: right", "file: right")),
              HasSubstr("line 12: unknown key 'file', did you mean 'id'? known keys: id, path, "
                        "projection_matrix"));
  EXPECT_THAT(
      error_of(patch_with("k1:", "K1:")),
      HasSubstr("line 13: unknown key 'K1', did you mean 'k1'? known keys: focal_length_mm, "));
  EXPECT_THAT(
      error_of(patch_with("position_m", "position")),
      HasSubstr(
          "line 14: unknown key 'position', did you mean 'position_m'? known keys: position_m, "));
}

TEST(ReadPatch, NamesWhatIsWrongWithItsLine) {
  struct Case {
    const char* what;
    const char* replacement;
    const char* message;
  };
  for (const Case& c : {
           Case{"id: \"1\"\n", "", "key 'id' is missing"},
           Case{"height_range: [250, 300]\n", "", "key 'height_range' is missing"},
           Case{"[250, 300]", "[300, 250]", "line 3: height_range = [300, 250]; must be [lowest"},
           Case{"[250, 300]", "[250, 250]", "line 3: height_range = [250, 250]; must be [lowest"},
           Case{"[250, 300]", "[250]", "line 3: height_range must be a list of 2 numbers"},
           Case{"[250, 300]", "[250, high]", "height_range = high; must be a finite number"},
           Case{"EPSG:25832+7837", "EPSG:1", "line 2: crs: "},
           Case{"-512.0", ".nan", "line 8: a row of projection_matrix = .nan; must be a finite"},
           Case{"-512.0", "nan", "line 8: a row of projection_matrix = nan; must be a finite"},
           Case{", 409600.0]", "]", "line 8: a row of projection_matrix must be a list of 4"},
           Case{"[0.0, 0.0, -1.0, 800.0]", "[0.0, 0.0, 0.0, 1.0]", "has rank < 3"},
           Case{"      - [0.0, 0.0, -1.0, 800.0]\n", "", "must have three rows of four numbers"},
           Case{"    window_px", "    projection_matrix: []\n    window_px",
                "projection_matrix cannot be combined with"},
           Case{"focal_length_mm: 120", "focal_length_mm: 0", "line 13: focal_length_mm = 0"},
           Case{"[7680, 13824]", "[7680]", "size_px must be a list of 2 numbers"},
           Case{"id: right", "id: left", "two images have the id left"},
           Case{"id: left", "id: left\n    id: left", "key 'id' appears twice"},
           Case{"path: right.tif", "path: [a, b]", "line 12: path must be a string"},
           Case{"lidar:", "colmap: sparse/0\nlidar:", "one of the keys images and colmap"},
           Case{"height_range:", "height_range: [", "line 4: "},
           Case{"[250, 300]", "high", "height_range = high; must be [lowest, highest] or auto"},
           Case{"lidar:", "surface_model: dsm.tif\nlidar:",
                "surface_model is only used with height_range: auto"},
           Case{"lidar:", "area: [0, 0, 0, 9]\nlidar:", "min <= max"},
           Case{"lidar:", "area: [0, 0, 9]\nlidar:", "area must be a list of 4 numbers"},
           Case{"lidar:", "area: none.gpkg\nlidar:", "none.gpkg: does not exist"},
           Case{"lidar:", "max_views: 3\nlidar:", "max_views requires area"},
           Case{"lidar:", "area: [0, 0, 9, 9]\nmax_views: 3\nlidar:", "are all used"},
           Case{"[3000, 6000]", "[3000, 6000, 1, 5]",
                "window_px = [3000, 6000, 1, 5]; must be whole"},
           Case{"[3000, 6000]", "[0.5, 6000, 10, 5]", "must be whole numbers"},
           Case{"    window_px", "    radiometry: [[3, 3]]\n    window_px",
                "radiometry has [3, 3]"},
           Case{"    window_px", "    radiometry: []\n    window_px",
                "must be a list of [low, high]"},
           Case{"lidar:", "segments: lsd.csv\nlidar:",
                "line 16: a mapping is expected; known keys: left, right"},
           Case{"lidar:", "segments: {rigth: a.csv}\nlidar:",
                "line 16: unknown key 'rigth', did you mean 'right'?"},
           Case{"lidar:", "segments: {left: a.csv, left: b.csv}\nlidar:",
                "key 'left' appears twice"},
           Case{"lidar:", "segment_sigma_px: 1\nlidar:", "segment_sigma_px requires segments"},
           Case{"lidar:", "segments: {left: a.csv}\nsegment_sigma_px: 0\nlidar:",
                "line 17: segment_sigma_px = 0; must be positive"},
       }) {
    EXPECT_THAT(error_of(patch_with(c.what, c.replacement)), HasSubstr(c.message)) << c.what;
  }
}

TEST(ReadPatch, NamesFilesOfSegmentsByImage) {
  const TempFolder folder;
  const PatchFile patch = read_patch(folder.write(
      "patch.yaml",
      patch_with("lidar:", "segments: {right: lsd/right.csv}\nsegment_sigma_px: 0.5\nlidar:")));
  EXPECT_EQ(patch.images[0].segments, std::nullopt);
  EXPECT_EQ(patch.images[1].segments, folder.file("lsd/right.csv"));
  EXPECT_EQ(patch.images[1].segment_sigma_px, 0.5);
  EXPECT_EQ(read_patch(folder.write("patch.yaml", kPatch)).images[1].segment_sigma_px,
            kDefaultSegmentSigma_px);
}

TEST(ReadPatch, WindowOfFourNumbersIsWhatIsReadOfTheFrame) {
  const TempFolder folder;
  const PatchImage cut = read_patch(folder.write("patch.yaml", patch_with("x", "x"))).images[1];
  const PatchImage read =
      read_patch(
          folder.write("patch.yaml",
                       patch_with("[3000, 6000]",
                                  "[3000, 6000, 512, 400]\n    radiometry: [[0, 9], [5, 200]]")))
          .images[1];
  EXPECT_FALSE(cut.window);
  EXPECT_EQ(read.window, (Window{3000, 6000, 512, 400}));
  EXPECT_EQ(read.window_px, cut.window_px);
  EXPECT_EQ(read.image_from_world, cut.image_from_world);
  ASSERT_EQ(read.radiometry.size(), 2U);
  EXPECT_EQ(read.radiometry[1], (std::array{5.0, 200.0}));
}

TEST(ReadPatch, AreaIsTheBoundsOrTheHullOfAFileAndHeightsMayBeOpen) {
  const TempFolder folder;
  const PatchFile bounds = read_patch(
      folder.write("patch.yaml", patch_with("[250, 300]", "auto\narea: [10, 20, 30, 50]")));
  EXPECT_EQ(bounds.height_range_m, std::nullopt);
  const std::vector<Eigen::Vector2d> corners{{10, 20}, {30, 20}, {30, 50}, {10, 50}};
  EXPECT_EQ(bounds.area_m, corners);
  EXPECT_EQ(bounds.max_views, std::nullopt);
  const std::string square =
      R"({"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]}})";
  const std::string utm32 =
      R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}},)";
  const std::string utm33 =
      R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25833"}},)";
  const auto collection = [&](const std::string& crs) {
    return R"({"type":"FeatureCollection",)" + crs + R"("features":[)" + square + "]}";
  };
  (void)folder.write("area.geojson", collection(utm32));
  EXPECT_EQ(
      read_patch(folder.write("patch.yaml", patch_with("lidar:", "area: area.geojson\nlidar:")))
          .area_m.size(),
      4U);
  (void)folder.write("area.geojson", collection(utm33));
  EXPECT_THROW((void)read_patch(
                   folder.write("patch.yaml", patch_with("lidar:", "area: area.geojson\nlidar:"))),
               IoError);
}

TEST(ReadPatch, RefusesTwoCamerasInOnePlace) {
  const std::string image =
      "  - {id: ID, path: a.png, projection_matrix: [[1,0,0,-5],[0,1,0,0],[0,0,1,0]]}\n";
  const std::string head = "id: 1\nheight_range: [0, 1]\nimages:\n";
  EXPECT_THAT(error_of(head + std::regex_replace(image, std::regex("ID"), "a") +
                       std::regex_replace(image, std::regex("ID"), "b")),
              HasSubstr("the cameras of a and b have the same position"));
  EXPECT_THAT(error_of(head + image), HasSubstr("1 images; at least two are required"));
}

TEST(ReadPatch, RefusesFilesThatAreNoPatch) {
  EXPECT_THAT(error_of(""), HasSubstr("is empty"));
  EXPECT_THAT(error_of("- 1\n- 2\n"), HasSubstr("a mapping is expected"));
  EXPECT_THAT(error_of("id: a\n---\nid: b\n"), HasSubstr("line 3: a second document begins"));
  EXPECT_THAT(error_of("\x89PNG\r\n\x1a\n"), HasSubstr("patch.yaml: "));
  EXPECT_THAT(io_error_of([] { read_patch("/nowhere/patch.yaml"); }),
              HasSubstr("/nowhere/patch.yaml: no such file"));
}

TEST(ReadPatch, ReadsTheVaihingenPatch) {
  const std::string path = test::shared_data_dir() + "/vaihingen/patch.yaml";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const PatchFile patch = read_patch(path);
  ASSERT_EQ(patch.images.size(), 2U);
  EXPECT_LT((projection_centre(patch.images[1].image_from_world).hnormalized() -
             Eigen::Vector3d(246.0, 0.0, 800.0))
                .norm(),
            kPatchPixelTolerance);
  ASSERT_EQ(patch.lidar.size(), 1U);
  EXPECT_TRUE(std::filesystem::exists(patch.lidar[0]));
}

TEST(ReadPatch, ReadsTheFilesOfEarlierVersions) {
  const std::string folder = test::source_dir() + "/tests/compatibility/0.2/patches/";
  for (const char* name : {"matrices.yaml", "frames.yaml", "orientation.yaml"}) {
    const PatchFile patch = read_patch(folder + name);
    ASSERT_EQ(patch.images.size(), 2U) << name;
    for (const PatchImage& image : patch.images)
      EXPECT_FALSE(image.image_from_world.isZero()) << name;
  }
}

TEST(ReadPatch, RefusesTextThatBeginsNoValue) {
  const TempFolder folder;
  for (const char* text : {", 900]\n", "id: 1\n--- \n, b\n"}) {
    const std::string path = folder.write("patch.yaml", text);
    EXPECT_THAT(io_error_of([&] { read_patch(path); }), HasSubstr("not YAML: a value is expected"));
  }
}

}  // namespace
}  // namespace ridgeline::io
