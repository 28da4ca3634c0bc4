// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/area_heights.h"

#include "io/error.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace ridgeline::apps {
namespace {

TEST(HeightLimits, AreTheLowestAndTheHighestWithoutFewHeightsFarFromAllOthers) {
  std::vector<double> heights;
  for (int i = 0; i <= 4000; ++i) heights.push_back(200.0 + 0.01 * i);
  heights.push_back(520.0);  // a bird
  heights.push_back(-40.0);
  const auto [low, high] = height_limits_m(heights);
  EXPECT_EQ(low, 200.0);
  EXPECT_EQ(high, 240.0);
  for (int i = 0; i < 10; ++i) heights.push_back(300.0 + i);  // a tower
  EXPECT_EQ(height_limits_m(heights)[1], 309.0);
  EXPECT_EQ(height_limits_m(std::vector{7.0}), (std::array{7.0, 7.0}));
}

/// A patch of 100 m x 100 m whose LIDAR has a point each metre at the height 50 m + x / 10, and 900
/// m beside it.
io::PatchFile patch_on_slope(const io::TempFolder& folder) {
  std::string points;
  for (int x = 0; x < 100; ++x)
    for (int y = 0; y < 100; ++y) points += fmt::format("{} {} {}\n", x, y, 50.0 + 0.1 * x);
  for (int i = 0; i < 500; ++i) points += fmt::format("150 {} 900\n", i);
  io::PatchFile patch;
  patch.path = "patch.yaml";
  patch.lidar = {folder.write("lidar.xyz", points)};
  return patch;
}

TEST(AreaHeights, AreThoseOfTheLidarWithinTheArea) {
  const io::TempFolder folder;
  io::PatchFile patch = patch_on_slope(folder);
  patch.area_m = {{20.0, 10.0}, {60.0, 10.0}, {60.0, 90.0}, {20.0, 90.0}};
  std::vector<std::string> warnings;
  const std::vector<double> heights_m = area_heights_m(patch, warnings);
  EXPECT_TRUE(warnings.empty());
  constexpr double kRounding_m = 1e-6;
  EXPECT_NEAR(height_range_m(heights_m)[0], 52.0 - kHeightMargin_m, kRounding_m);
  EXPECT_NEAR(height_range_m(heights_m)[1], 56.0 + kHeightMargin_m, kRounding_m);
  EXPECT_EQ(heights_m.size(), 41U * 81U);
  patch.area_m = {{20.0, 10.0}, {60.0, 10.0}, {20.0, 50.0}};  // a triangle
  EXPECT_EQ(area_heights_m(patch, warnings).size(), 41U * 42U / 2U);
}

TEST(AreaHeights, WithoutAPointInTheAreaAreAnError) {
  const io::TempFolder folder;
  io::PatchFile patch = patch_on_slope(folder);
  patch.area_m = {{1000.0, 0.0}, {1100.0, 0.0}, {1100.0, 100.0}};
  std::vector<std::string> warnings;
  EXPECT_THROW((void)area_heights_m(patch, warnings), io::IoError);
}

TEST(AreaHeights, ThatNoSurfaceHasAreLeftOutAndCounted) {
  const io::TempFolder folder;
  io::PatchFile patch = patch_on_slope(folder);
  std::string points = folder.read("lidar.xyz");
  for (int i = 0; i < 300; ++i)
    points += fmt::format("{} 20 {}\n", i % 100, i < 100 ? -9999 : 99999);
  patch.lidar = {folder.write("lidar.xyz", points)};
  patch.area_m = {{0.0, 0.0}, {100.0, 0.0}, {100.0, 100.0}, {0.0, 100.0}};
  std::vector<std::string> warnings;
  constexpr double kRounding_m = 1e-6;
  EXPECT_NEAR(height_range_m(area_heights_m(patch, warnings))[0], 50.0 - kHeightMargin_m,
              kRounding_m);
  EXPECT_THAT(warnings, testing::ElementsAre(testing::HasSubstr(
                            "patch.yaml: height_range: auto: 300 of 10300 heights of LIDAR points "
                            "are below -500 m or above 9000 m")));
}

}  // namespace
}  // namespace ridgeline::apps
