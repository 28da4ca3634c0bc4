// SPDX-License-Identifier: BSD-3-Clause
// Orientations as users reported them, against the block that they were made from.
#include "io/orientation/read_orientation.h"
#include "reconstruct/geometry/degrees.h"
#include "tests/support/paths.h"
#include "tests/support/temp_folder.h"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace ridgeline::io {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class ReportedOrientation : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_)) GTEST_SKIP() << folder_ << " is not there";
  }

  Orientation read(const std::string& file) const {
    OrientationOptions options;
    options.cameras = folder_ + "/base/cam.yaml";
    return read_orientation(folder_ + "/" + file, options);
  }

  /// Images of the block by the number in their names: DSC_0001.JPG.
  static int number_of(const OrientedImage& image) {
    const std::string name = file_name_of(image);
    return std::stoi(name.substr(name.find_first_of("123456789")));
  }

  /// The largest distance, m, and the largest difference of rotations, rad, from the block.
  void expect_block(const Orientation& orientation, double tolerance_m, double tolerance_rad) {
    const Orientation block = read("base/blocks.xml");
    for (const OrientedImage& image : orientation.images) {
      const auto truth = std::ranges::find(block.images, number_of(image), number_of);
      ASSERT_NE(truth, block.images.end()) << image.name;
      const ExteriorOrientation& pose = truth->exterior;
      EXPECT_LT((image.exterior.position_m - pose.position_m).norm(), tolerance_m) << image.name;
      EXPECT_LT((image.exterior.world_from_camera_axes - pose.world_from_camera_axes).norm(),
                tolerance_rad)
          << image.name;
    }
  }

  std::string folder_ = test::shared_data_dir() + "/reported_2";
};

/// Digits of the files.
constexpr double kDigits_m = 1e-3;
constexpr double kDigits_rad = 1e-6;
/// Geocentric poses come back to a map that bends and stretches.
constexpr double kOnMap_m = 0.01;
constexpr double kOnMap_rad = 1e-4;

TEST_F(ReportedOrientation, OfTheSameBlockIsTheSameInEveryFormat) {
  for (const char* file : {"base/pix_calibrated_camera_parameters.txt", "base/opk.csv"}) {
    SCOPED_TRACE(file);
    const Orientation orientation = read(file);
    EXPECT_THAT(orientation.images, SizeIs(6));
    expect_block(orientation, kDigits_m, kDigits_rad);
  }
  for (const char* file : {"base/metashape.xml", "base/reconstruction.json"}) {
    SCOPED_TRACE(file);
    expect_block(read(file), kOnMap_m, kOnMap_rad);
  }
}

TEST_F(ReportedOrientation, LeavesOutAComponentOfMetashapeWithoutAPlace) {
  const Orientation orientation = read("01-metashape-components/two_components.xml");
  EXPECT_THAT(orientation.images, SizeIs(6));
  expect_block(orientation, kOnMap_m, kOnMap_rad);
  EXPECT_THAT(orientation.warnings,
              Contains(HasSubstr("images of a component without a place, left out: 2")));
}

TEST_F(ReportedOrientation, LeavesOutDisabledImagesOfMetashape) {
  const Orientation orientation = read("02-metashape-disabled/disabled.xml");
  EXPECT_THAT(orientation.images, SizeIs(4));
  EXPECT_THAT(orientation.warnings,
              Contains("disabled images, left out: 2 (DSC_0002.JPG, DSC_0005.JPG)"));
}

TEST_F(ReportedOrientation, OfGeocoordsIsOnTheMap) {
  const Orientation orientation = read("07-odm-geocoords/reconstruction.geocoords.json");
  EXPECT_EQ(orientation.crs.definition, "EPSG:32632");
  expect_block(orientation, kDigits_m, kDigits_rad);
}

TEST_F(ReportedOrientation, NeedsNoCameraThatNoImageUses) {
  EXPECT_THAT(read("08-unused-camera/unused.json").images, SizeIs(6));
}

TEST_F(ReportedOrientation, OfPix4dNamesTheOffsetThatIsMissing) {
  const std::vector<std::string> warnings =
      read("09-pix4d-no-offset/p_calibrated_camera_parameters.txt").warnings;
  EXPECT_THAT(warnings, Contains(HasSubstr("has no p_offset.xyz next to it")));
  EXPECT_THAT(warnings, Contains(AllOf(HasSubstr("x = 0, y = "), HasSubstr("km outside the area"),
                                       HasSubstr("WGS 84 / UTM zone 32N"))));
}

TEST_F(ReportedOrientation, OfPix4dMayBeRenamedWithItsOffset) {
  expect_block(read("09-pix4d-no-offset/params.txt"), kDigits_m, kDigits_rad);
}

TEST_F(ReportedOrientation, SaysWhatToDoAboutTwoImagesOfOneName) {
  const auto error =
      io_error_of([&] { read("10-duplicate-names/d_calibrated_camera_parameters.txt"); });
  EXPECT_THAT(error, HasSubstr("two images are named DSC_0001.JPG; rename one of the files"));
}

TEST_F(ReportedOrientation, OfBlocksExchangeMayHaveYawPitchRoll) {
  for (const OrientedImage& image : read("12-blocks-angles/ypr.xml").images) {
    const std::vector<double> kappa_deg{0.0, 1.0, 2.0, 183.0, 184.0, 185.0};
    const Eigen::AngleAxisd kappa(
        kRadPerDeg * kappa_deg.at(static_cast<std::size_t>(number_of(image)) - 1),
        Eigen::Vector3d::UnitZ());
    EXPECT_TRUE(image.exterior.world_from_camera_axes.isApprox(kappa.toRotationMatrix(), 1e-9))
        << image.name;
  }
}

TEST_F(ReportedOrientation, LeavesOutOtherComponentsOfBlocksExchange) {
  const Orientation orientation = read("13-blocks-component/components.xml");
  EXPECT_THAT(orientation.images, SizeIs(4));
  expect_block(orientation, kDigits_m, kDigits_rad);
  EXPECT_THAT(orientation.warnings,
              Contains("photos of other components, left out: 2 (DSC_0005.JPG, DSC_0006.JPG)"));
}

TEST_F(ReportedOrientation, MayHaveDecimalCommasAndGermanColumns) {
  for (const char* file : {"excel.csv", "excel_cp1252.csv", "blanks.txt"}) {
    SCOPED_TRACE(file);
    const Orientation orientation = read(fmt::format("14-opk-decimal-comma/{}", file));
    EXPECT_THAT(orientation.images, SizeIs(6));
    expect_block(orientation, kDigits_m, kDigits_rad);
  }
  EXPECT_THAT(io_error_of([&] { read("14-opk-decimal-comma/utf16.csv"); }), HasSubstr("UTF-16"));
}

}  // namespace
}  // namespace ridgeline::io
