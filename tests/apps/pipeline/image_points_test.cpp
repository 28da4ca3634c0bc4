// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/image_points.h"

#include "io/orientation/read_orientation.h"
#include "tests/support/paths.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

#include <filesystem>

namespace ridgeline::apps {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Most points are exact to half a pixel of an image that is reduced to half.
constexpr double kRaysMeet_px = 1.0;

TEST(FindImagePoints, MakesTheRaysOfRealOpensfmMeet) {
  const std::string folder = test::shared_data_dir() + "/drone_odm";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  io::Orientation orientation = io::read_orientation(folder + "/reconstruction.json");
  const std::vector<io::PointObservation> points = find_image_points(orientation, folder);
  const std::optional<double> distance_px = io::median_ray_distance_px(orientation, points);
  ASSERT_TRUE(distance_px.has_value());
  RecordProperty("median_px", std::to_string(*distance_px));
  EXPECT_LT(*distance_px, kRaysMeet_px);
  for (io::Camera& camera : orientation.cameras) camera.interior.distortion = {};
  EXPECT_GT(io::median_ray_distance_px(orientation, points).value(), 3.0 * *distance_px);
}

TEST(FindImagePoints, ScalesFilesOfAnotherSizeThanTheCamera) {
  const std::string folder = test::shared_data_dir() + "/orientations/ngi";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const io::TempFolder cameras;
  io::OrientationOptions options;
  options.cameras = cameras.write(
      "dmc.yaml", "DMC: {focal_length_mm: 120, pixel_size_um: 12, size_px: [7680, 13824]}\n");
  options.find_observations = [&](const io::Orientation& orientation) {
    return find_image_points(orientation, folder);
  };
  const io::Orientation orientation = io::read_orientation(folder + "/ngi_xyz_opk.csv", options);
  ASSERT_EQ(orientation.decisions.size(), 1U);
  // a pixel of the files is twelve of the camera
  EXPECT_THAT(orientation.decisions[0],
              HasSubstr("Determined: angles in deg (with angles in deg rays intersect within 2"));
}

TEST(FindImagePoints, FindsNoneWhereImagesAreMissing) {
  const std::string fixtures = test::source_dir() + "/tests/io/orientation/fixtures";
  const io::TempFolder folder;
  const io::Orientation orientation = io::read_orientation(fixtures + "/metashape_local.xml");
  EXPECT_THAT(find_image_points(orientation, folder.file("")), IsEmpty());
  (void)folder.write("3.tif", "no image");
  EXPECT_THAT(find_image_points(orientation, folder.file("")), IsEmpty());
}

TEST(ImageFileIn, TakesNamesWithAndWithoutTheirExtension) {
  const io::TempFolder folder;
  const std::string file = folder.write("H\xC3\xB6he 2.JPG", "x");
  EXPECT_EQ(image_file_in(folder.file(""), {"H\xC3\xB6he 2", {}, {}}), file);
  EXPECT_EQ(image_file_in(folder.file(""), {"D:\\a\\H\xC3\xB6he 2.JPG", {}, {}}), file);
  EXPECT_EQ(image_file_in(folder.file(""), {"H\xC3\xB6he 3", {}, {}}), std::nullopt);
}

}  // namespace
}  // namespace ridgeline::apps
