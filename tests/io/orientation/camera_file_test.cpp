// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/camera_file.h"

#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

namespace ridgeline::io {
namespace {

using ::testing::HasSubstr;

constexpr double kRounding_px = 1e-9;

std::vector<Camera> cameras_of(const std::string& text) {
  const TempFolder folder;
  return read_cameras(folder.write("cameras.yaml", text)).cameras;
}

std::string error_of(const std::string& text) {
  return io_error_of([&] { cameras_of(text); });
}

TEST(ReadCameras, TakesMillimetresAndUnitsOfTheLongerSide) {
  const std::vector<Camera> cameras = cameras_of(
      "metric: {focal_length_mm: 120, pixel_size_um: 12, size_px: [7680, 13824], "
      "principal_point_mm: [0.12, 0.24], k1: 0.1}\n"
      "sensor: {type: pinhole, im_size: [640, 1152], focal_len: 120, sensor_size: [92.16, "
      "165.888], "
      "cx: 0.01}\n"
      "longer side: {type: brown, im_size: [1000, 500], focal_len: 0.8, cy: -0.02, p2: 0.3}\n");
  ASSERT_EQ(cameras.size(), 3U);
  EXPECT_EQ(cameras[2].name, "longer side");
  const auto is_near = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - b).norm() < kRounding_px;
  };
  EXPECT_TRUE(is_near(cameras[0].interior.focal_length_px, {10000.0, 10000.0}));
  EXPECT_TRUE(is_near(cameras[0].interior.principal_point_px, {3839.5 + 10.0, 6911.5 - 20.0}));
  EXPECT_TRUE(is_near(cameras[1].interior.focal_length_px, {120.0 / 0.144, 120.0 / 0.144}));
  EXPECT_TRUE(is_near(cameras[1].interior.principal_point_px, {319.5 + 11.52, 575.5}));
  EXPECT_TRUE(is_near(cameras[2].interior.focal_length_px, {800.0, 800.0}));
  EXPECT_TRUE(is_near(cameras[2].interior.principal_point_px, {499.5, 249.5 - 20.0}));
  EXPECT_EQ(cameras[0].interior.distortion.k1, 0.1);
  EXPECT_EQ(cameras[2].interior.distortion.p2, 0.3);
}

TEST(ReadCameras, SaysWhatIsWrong) {
  EXPECT_THAT(error_of("[1, 2]\n"), HasSubstr("is not a camera file"));
  EXPECT_THAT(error_of("c: {type: fisheye, im_size: [9, 9], k4: 1}\n"),
              HasSubstr("camera type fisheye; supported are pinhole and brown"));
  EXPECT_THAT(error_of("c: {im_size: [9, 9], focal_len: 1}\n"), HasSubstr("type"));
  EXPECT_THAT(error_of("c: {type: brown, im_size: [9, 9.5], focal_len: 1}\n"),
              HasSubstr("must be whole numbers of pixels"));
  EXPECT_THAT(error_of("c: {type: brown, im_size: [9, 9], focal_len: 0}\n"),
              HasSubstr("must be positive"));
  EXPECT_THAT(error_of("c: {type: brown, im_size: [9, 9], focal_len: 1, k9: 1}\n"),
              HasSubstr("k9"));
  EXPECT_THAT(error_of("c: {focal_length_mm: -1, pixel_size_um: 1, size_px: [9, 9]}\n"),
              HasSubstr("focal_length_mm = -1"));
}

TEST(LargestRadius, ReachesTheFarthestCorner) {
  InteriorOrientation interior;
  interior.focal_length_px = {1000.0, 500.0};
  interior.principal_point_px = {400.0, 100.0};
  EXPECT_EQ(largest_radius(interior), 0.0);
  interior.size_px = Eigen::Vector2i(700, 400);
  EXPECT_DOUBLE_EQ(largest_radius(interior), std::hypot(0.4, 0.6));
}

}  // namespace
}  // namespace ridgeline::io
