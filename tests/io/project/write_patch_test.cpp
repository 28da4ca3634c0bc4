// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/write_patch.h"

#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ridgeline::io {
namespace {

PatchFile sample_patch() {
  PatchFile patch;
  patch.id = "7";
  patch.crs.definition = "EPSG:25832";
  patch.height_range_m = {229.0, 280.0};
  for (int i = 0; i < 2; ++i) {
    PatchImage image;
    image.id = i == 0 ? "left" : "right";
    image.path = image.id + ".tif";
    // map coordinates need all digits of a double
    image.image_from_world << 10000.0 / 3.0, 0.1, -512.0, -1710000000.123456789 + 1e6 * i, 0.2,
        -9999.9, -512.0, 54030000000.98765, -0.01, 0.02, -1.0, 6000.123456789;
    patch.images.push_back(image);
  }
  patch.lidar = {"lidar.las"};
  patch.reference_matches = "matches.csv";
  patch.reference_tracks = "tracks.csv";
  patch.reference_lines = "truth.geojson";
  return patch;
}

TEST(WritePatch, IsReadBackWithoutLoss) {
  const TempFolder folder;
  const std::string path = folder.file("patch.yaml");
  PatchFile written = sample_patch();
  written.images[1].segments = "lsd.right.csv";
  written.images[1].segment_sigma_px = 0.25;
  write_patch(path, written);
  const PatchFile read = read_patch(path);
  EXPECT_EQ(read.id, written.id);
  EXPECT_EQ(read.crs.definition, written.crs.definition);
  EXPECT_EQ(read.height_range_m, written.height_range_m);
  ASSERT_EQ(read.images.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.images[i].id, written.images[i].id);
    EXPECT_EQ(read.images[i].image_from_world, written.images[i].image_from_world);
  }
  EXPECT_THAT(read.images[1].path, ::testing::EndsWith("right.tif"));
  EXPECT_THAT(read.lidar, ::testing::SizeIs(1));
  EXPECT_EQ(read.images[0].segments, std::nullopt);
  EXPECT_EQ(read.images[1].segments, folder.file("lsd.right.csv"));
  EXPECT_EQ(read.images[1].segment_sigma_px, 0.25);
  EXPECT_EQ(read.reference_matches, folder.file("matches.csv"));
  EXPECT_EQ(read.reference_tracks, folder.file("tracks.csv"));
  EXPECT_EQ(read.reference_lines, folder.file("truth.geojson"));
}

TEST(WritePatch, NamesAnOrientationInPlaceOfMatricesAndTheArea) {
  const TempFolder folder;
  PatchFile patch = sample_patch();
  patch.lidar.clear();
  patch.reference_matches = patch.reference_tracks = patch.reference_lines = std::nullopt;
  patch.area_m = {
      {513002.0, 5403002.5}, {513118.0, 5403002.5}, {513118.0, 5403118.0}, {513002.0, 5403118.0}};
  PatchKeys keys;
  keys.orientation = "pat_b.ori";
  keys.cameras = "cameras.yaml";
  keys.matrix = "world_from_camera";
  write_patch(folder.file("patch.yaml"), patch, keys);
  EXPECT_EQ(folder.read("patch.yaml"),
            "id: \"7\"\ncrs: EPSG:25832\nheight_range: [229, 280]\n"
            "area: [513002, 5403002.5, 513118, 5403118]\n"
            "orientation: pat_b.ori\ncameras: cameras.yaml\nmatrix: world_from_camera\n"
            "images:\n  - path: left.tif\n  - path: right.tif\n");
}

TEST(WritePatch, StatesCamerasWithDistortionAndWindows) {
  const TempFolder folder;
  PatchFile patch = sample_patch();
  patch.lidar.clear();
  for (PatchImage& image : patch.images) {
    image.interior = InteriorOrientation{.focal_length_px = {10000.0 / 3.0, 3331.0},
                                         .principal_point_px = {2047.25, 1535.5},
                                         .distortion = {0.01, -0.02, 0.001, 1e-4, -2e-4},
                                         .size_px = Eigen::Vector2i(4096, 3072)};
    image.exterior = ExteriorOrientation{
        .position_m = {513000.1 / 3.0 + (image.id == "left" ? 0.0 : 60.0), 5403000.7, 1500.3},
        .world_from_camera_axes = world_from_camera_axes(0.02, -0.7, 3.0)};
    image.image_from_world = projection_matrix(*image.interior, *image.exterior);
    image.radiometry = {{1.0 / 3.0, 250.0}, {7.0, 240.5}};
  }
  read_window_only(patch.images[0], {100, 200, 640, 480});
  const std::string path = folder.file("patch.yaml");
  write_patch(path, patch);
  const PatchFile read = read_patch(path);
  for (std::size_t i = 0; i < 2; ++i) {
    const PatchImage& image = read.images[i];
    EXPECT_EQ(image.interior->focal_length_px, patch.images[i].interior->focal_length_px);
    EXPECT_EQ(image.interior->principal_point_px, patch.images[i].interior->principal_point_px);
    EXPECT_EQ(image.interior->size_px, patch.images[i].interior->size_px);
    EXPECT_EQ(image.interior->distortion.p2, -2e-4);
    EXPECT_EQ(image.radiometry, patch.images[i].radiometry);
    EXPECT_EQ(image.window_px, patch.images[i].window_px);
    // Angles are rounded to the digits of a double.
    EXPECT_TRUE(image.image_from_world.isApprox(patch.images[i].image_from_world, 1e-14));
  }
  EXPECT_EQ(read.images[0].window->width, 640);
  EXPECT_FALSE(read.images[1].window);
}

TEST(WritePatch, RefusesWhatAPatchFileCannotState) {
  const TempFolder folder;
  PatchFile patch = sample_patch();
  patch.area_m = {{0.0, 0.0}, {4.0, 0.0}, {2.0, 3.0}};
  EXPECT_THROW(write_patch(folder.file("patch.yaml"), patch), std::invalid_argument);
  patch.area_m.clear();
  patch.height_range_m.reset();
  EXPECT_THROW(write_patch(folder.file("patch.yaml"), patch), std::invalid_argument);
}

TEST(WritePatch, RefusesACameraWithoutItsPose) {
  const TempFolder folder;
  PatchFile patch = sample_patch();
  patch.images[0].interior = InteriorOrientation{};
  EXPECT_THROW(write_patch(folder.file("patch.yaml"), patch), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::io
