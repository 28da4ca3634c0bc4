// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/colmap.h"

#include "io/project/patch.h"
#include "tests/support/temp_folder.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>

namespace ridgeline::io {
namespace {

using ::testing::HasSubstr;

constexpr double kPixelTolerance = 1e-9;

// Image 1 turned by 90 degrees about the viewing axis; image 2 without points and with a blank in
// its name.
constexpr const char* kCameras =
    "# Camera list\n"
    "1 OPENCV 640 480 500 510 320.5 240.5 0.1 0.02 0.003 0.004\n"
    "2 SIMPLE_RADIAL 640 480 400 320.5 240.5 -0.05\n";
constexpr const char* kImages =
    "# Image list\n"
    "2 1 0 0 0 1 2 3 2 the right.jpg\n"
    "\n"
    "1 0.70710678118654752 0 0 0.70710678118654752 0 0 5 1 left.jpg\n"
    "10.0 20.0 -1 11.0 21.0 7\n";

std::string folder_of(const TempFolder& folder,
                      const std::string& cameras = kCameras,
                      const std::string& images = kImages) {
  (void)folder.write("sparse/cameras.txt", cameras);
  (void)folder.write("sparse/images.txt", images);
  return folder.file("sparse");
}

template <typename T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string binary_cameras() {
  std::string bytes;
  append<std::uint64_t>(bytes, 2);
  append<std::uint32_t>(bytes, 1);
  append<std::int32_t>(bytes, 4);
  for (const std::uint64_t size : {640, 480}) append(bytes, size);
  for (const double p : {500.0, 510.0, 320.5, 240.5, 0.1, 0.02, 0.003, 0.004}) append(bytes, p);
  append<std::uint32_t>(bytes, 2);
  append<std::int32_t>(bytes, 2);
  for (const std::uint64_t size : {640, 480}) append(bytes, size);
  for (const double p : {400.0, 320.5, 240.5, -0.05}) append(bytes, p);
  return bytes;
}

std::string binary_images() {
  std::string bytes;
  append<std::uint64_t>(bytes, 2);
  append<std::uint32_t>(bytes, 2);
  for (const double v : {1.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0}) append(bytes, v);
  append<std::uint32_t>(bytes, 2);
  bytes += std::string("the right.jpg") + '\0';
  append<std::uint64_t>(bytes, 0);
  append<std::uint32_t>(bytes, 1);
  for (const double v : {0.70710678118654752, 0.0, 0.0, 0.70710678118654752, 0.0, 0.0, 5.0}) {
    append(bytes, v);
  }
  append<std::uint32_t>(bytes, 1);
  bytes += std::string("left.jpg") + '\0';
  append<std::uint64_t>(bytes, 1);
  bytes += std::string(24, 'x');
  return bytes;
}

TEST(ReadColmap, ProjectsAsColmapButHalfAPixelLess) {
  const TempFolder folder;
  const std::vector<ColmapImage> images = read_colmap(folder_of(folder));
  ASSERT_EQ(images.size(), 2U);
  EXPECT_EQ(images[0].id, 1U);
  EXPECT_EQ(images[1].name, "the right.jpg");
  const ProjectionMatrix P = projection_matrix(images[0].interior, images[0].exterior);
  // The turn takes (1, 2, 5) to (-2, 1, 5 + 5): pixel 320.5 - 500 * 0.2, 240.5 + 510 * 0.1.
  const Eigen::Vector2d expected(320.5 - 100.0 - 0.5, 240.5 + 51.0 - 0.5);
  EXPECT_LT((project(P, Eigen::Vector3d(1.0, 2.0, 5.0)) - expected).norm(), kPixelTolerance);
  EXPECT_DOUBLE_EQ((P * Eigen::Vector4d(1.0, 2.0, 5.0, 1.0)).z(), 10.0);
}

TEST(ReadColmap, AssignsTheParametersOfEachModel) {
  const TempFolder folder;
  const std::vector<ColmapImage> images = read_colmap(folder_of(folder));
  const BrownDistortion& opencv = images[0].interior.distortion;
  EXPECT_EQ(opencv.k1, 0.1);
  EXPECT_EQ(opencv.k2, 0.02);
  EXPECT_EQ(opencv.p1, 0.003);
  EXPECT_EQ(opencv.p2, 0.004);
  const InteriorOrientation& radial = images[1].interior;
  EXPECT_EQ(radial.focal_length_px, Eigen::Vector2d(400.0, 400.0));
  EXPECT_EQ(radial.principal_point_px, Eigen::Vector2d(320.0, 240.0));
  EXPECT_EQ(radial.distortion.k1, -0.05);
  EXPECT_EQ(radial.distortion.k2, 0.0);
  for (const char* camera : {"1 PINHOLE 9 9 500 510 4 5\n", "1 SIMPLE_PINHOLE 9 9 500 4 5\n",
                             "1 RADIAL 9 9 500 4 5 0.1 0.2\n"}) {
    const auto image = read_colmap(folder_of(folder, camera, "1 1 0 0 0 0 0 0 1 a.jpg\n\n")).at(0);
    EXPECT_EQ(image.interior.principal_point_px, Eigen::Vector2d(3.5, 4.5)) << camera;
    EXPECT_EQ(image.interior.focal_length_px.x(), 500.0) << camera;
  }
}

TEST(ReadColmap, ReadsTheSameFromBinary) {
  const TempFolder text_folder;
  const TempFolder binary_folder;
  (void)binary_folder.write("sparse/cameras.bin", binary_cameras());
  (void)binary_folder.write("sparse/images.bin", binary_images());
  const auto text = read_colmap(folder_of(text_folder));
  const auto binary = read_colmap(binary_folder.file("sparse"));
  ASSERT_EQ(binary.size(), text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    EXPECT_EQ(binary[i].id, text[i].id);
    EXPECT_EQ(binary[i].name, text[i].name);
    EXPECT_EQ(binary[i].interior.distortion.k1, text[i].interior.distortion.k1);
    EXPECT_EQ(projection_matrix(binary[i].interior, binary[i].exterior),
              projection_matrix(text[i].interior, text[i].exterior));
  }
}

TEST(ReadColmap, NeedsNoSupportForACameraWithoutImages) {
  const TempFolder folder;
  const std::string cameras = "3 OPENCV_FISHEYE 9 9 5 5 4 4 0.1 0.2 0.3 0.4\n";
  EXPECT_EQ(read_colmap(folder_of(folder, kCameras + cameras)).size(), 2U);
  EXPECT_THAT(io_error_of([&] {
                read_colmap(folder_of(folder, kCameras + cameras, "1 1 0 0 0 0 0 0 3 a.jpg\n\n"));
              }),
              HasSubstr("camera model OPENCV_FISHEYE; supported are"));
  std::string binary = binary_cameras();
  binary[0] = 3;  // cameras
  append<std::uint32_t>(binary, 3);
  append<std::int32_t>(binary, 5);
  for (const std::uint64_t size : {9, 9}) append(binary, size);
  for (const double p : {5.0, 5.0, 4.0, 4.0, 0.1, 0.2, 0.3, 0.4}) append(binary, p);
  (void)folder.write("binary/cameras.bin", binary);
  (void)folder.write("binary/images.bin", binary_images());
  EXPECT_EQ(read_colmap(folder.file("binary")).size(), 2U);
}

TEST(ColmapFiles, AreThoseOfCamerasAndImages) {
  const TempFolder folder;
  const std::string model = folder_of(folder);
  EXPECT_THAT(colmap_files(model),
              ::testing::ElementsAre(model + "/cameras.txt", model + "/images.txt"));
}

TEST(ReadColmap, SaysWhatIsWrong) {
  const TempFolder folder;
  const auto error_of = [&](const std::string& cameras, const std::string& images) {
    const std::string path = folder_of(folder, cameras, images);
    return io_error_of([&] { read_colmap(path); });
  };
  EXPECT_THAT(io_error_of([&] { read_colmap(folder.file("none")); }), HasSubstr("no such folder"));
  EXPECT_THAT(error_of("1 FISHEYE 9 9 1 2 3\n", kImages),
              HasSubstr("cameras.txt:1: camera model FISHEYE"));
  EXPECT_THAT(error_of("1 PINHOLE 9 9 1 2 3\n", kImages), HasSubstr("7 fields; PINHOLE has 8"));
  EXPECT_THAT(error_of("1 SIMPLE_PINHOLE 9 9 0 2 3\n", kImages), HasSubstr("focal length 0"));
  EXPECT_THAT(error_of("# none\n", kImages), HasSubstr("images.txt:2: camera 2 is not in"));
  EXPECT_THAT(error_of(kCameras, "1 1 0 0 0 1 2 3\n\n"),
              HasSubstr("images.txt:1: an image must be"));
  EXPECT_THAT(error_of(kCameras, "1 0 0 0 0 1 2 3 1 a\n\n"), HasSubstr("quaternion is zero"));
}

TEST(ReadColmap, NoticesEveryTruncationOfABinaryModel) {
  const TempFolder folder;
  (void)folder.write("cameras.bin", binary_cameras());
  const std::string images = binary_images();
  for (std::size_t size = 0; size < images.size(); ++size) {
    (void)folder.write("images.bin", std::string_view(images).substr(0, size));
    EXPECT_THAT(io_error_of([&] { read_colmap(folder.file(".")); }), HasSubstr("is truncated"))
        << size;
  }
}

/// A hole of 10 GB behind good images takes neither time nor memory.
TEST(ReadColmap, RefusesAHoleAtOnce) {
  constexpr std::uintmax_t kHuge_bytes = 10'000'000'000U;
  const TempFolder text;
  (void)folder_of(text);
  std::filesystem::resize_file(text.file("sparse/images.txt"), kHuge_bytes);
  EXPECT_THAT(io_error_of([&] { read_colmap(text.file("sparse")); }), HasSubstr("is not text"));
  const TempFolder binary;
  (void)binary.write("cameras.bin", binary_cameras());
  (void)binary.write("images.bin", "\x7f" + binary_images().substr(1));
  std::filesystem::resize_file(binary.file("images.bin"), kHuge_bytes);
  EXPECT_THAT(io_error_of([&] { read_colmap(binary.file(".")); }),
              HasSubstr("rotation quaternion"));
}

TEST(ReadPatch, TakesAColmapModelInPlaceOfImages) {
  const TempFolder folder;
  (void)folder_of(folder);
  const PatchFile patch = read_patch(folder.write(
      "patch.yaml", "id: 1\nheight_range: [0, 9]\ncolmap: sparse\ncolmap_images: images\n"));
  ASSERT_EQ(patch.images.size(), 2U);
  EXPECT_EQ(patch.images[1].path, folder.file("images/the right.jpg"));
  ASSERT_TRUE(patch.images[0].interior.has_value());
  EXPECT_EQ(patch.images[0].interior->distortion.k1, 0.1);
}

}  // namespace
}  // namespace ridgeline::io
