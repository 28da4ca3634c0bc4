// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/footprints.h"

#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <sqlite3.h>

#include <memory>
#include <numbers>

namespace ridgeline::io {
namespace {

using ::testing::HasSubstr;

constexpr double kPlanRounding_m = 1e-9;

/// Two vertical images of 100 m x 80 m from 100 m above ground at 50 m; the second one 50 m farther
/// east.
Orientation vertical_pair(double kappa_rad = 0.0) {
  Orientation orientation;
  orientation.cameras.push_back(
      {"c", {{1000.0, 1000.0}, {499.5, 399.5}, {}, Eigen::Vector2i(1000, 800)}});
  for (const double east_m : {0.0, 50.0}) {
    OrientedImage image;
    image.name = std::to_string(orientation.images.size());
    image.camera = 0;
    image.exterior.position_m = {1000.0 + east_m, 2000.0, 150.0};
    image.exterior.world_from_camera_axes = world_from_camera_axes(0.0, 0.0, kappa_rad);
    orientation.images.push_back(image);
  }
  return orientation;
}

TEST(Footprint, OfAVerticalImageIsItsFrameOnTheGround) {
  const Orientation orientation = vertical_pair();
  const auto ring = footprint(orientation, orientation.images[0], 50.0);
  ASSERT_TRUE(ring.has_value());
  ASSERT_EQ(ring->size(), 8U);
  EXPECT_LT(((*ring)[0] - Eigen::Vector3d(950.0, 2040.0, 50.0)).norm(), kPlanRounding_m);
  EXPECT_LT(((*ring)[2] - Eigen::Vector3d(1050.0, 2040.0, 50.0)).norm(), kPlanRounding_m);
  EXPECT_LT(((*ring)[4] - Eigen::Vector3d(1050.0, 1960.0, 50.0)).norm(), kPlanRounding_m);
  EXPECT_LT(((*ring)[6] - Eigen::Vector3d(950.0, 1960.0, 50.0)).norm(), kPlanRounding_m);
}

TEST(Footprint, IsNothingForAnImageThatLooksAtTheHorizonOrFromBelow) {
  Orientation orientation = vertical_pair();
  OrientedImage& image = orientation.images[0];
  EXPECT_FALSE(footprint(orientation, image, 151.0).has_value());
  image.exterior.world_from_camera_axes = world_from_camera_axes(std::numbers::pi / 3.0, 0.0, 0.0);
  EXPECT_FALSE(footprint(orientation, image, 50.0).has_value());
  image.camera.reset();
  EXPECT_FALSE(footprint(orientation, image, 50.0).has_value());
}

/// The single number that a query gives.
double number_in(const std::string& path, const std::string& query) {
  sqlite3* database = nullptr;
  sqlite3_open(path.c_str(), &database);
  const std::unique_ptr<sqlite3, decltype(&sqlite3_close)> owner(database, sqlite3_close);
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(database, query.c_str(), -1, &statement, nullptr);
  const std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> row(statement, sqlite3_finalize);
  return sqlite3_step(statement) == SQLITE_ROW ? sqlite3_column_double(statement, 0) : -1.0;
}

TEST(WriteOrientationMap, CountsTheImagesThatSeeAPlace) {
  const TempFolder folder;
  const std::string path = folder.file("plan.gpkg");
  write_orientation_map(path, vertical_pair(), 50.0);
  EXPECT_EQ(number_in(path, "SELECT count(*) FROM footprints"), 2.0);
  EXPECT_EQ(number_in(path, "SELECT count(*) FROM cameras"), 2.0);
  EXPECT_EQ(number_in(path, "SELECT max(n_images) FROM overlap"), 2.0);
  // 150 m are seen, the middle 50 m twice; cells are 2.2 m
  EXPECT_NEAR(number_in(path, "SELECT avg(n_images = 2) FROM overlap"), 1.0 / 3.0, 0.03);
}

TEST(WriteOrientationMap, CountsWithinTurnedFootprints) {
  const TempFolder folder;
  const std::string path = folder.file("plan.gpkg");
  write_orientation_map(path, vertical_pair(std::numbers::pi / 6.0), 50.0);
  // along its sides the other one lies 43.3 m and 25 m away
  const double both_m2 = (100.0 - 43.301) * (80.0 - 25.0);
  EXPECT_NEAR(number_in(path, "SELECT avg(n_images = 2) FROM overlap"),
              both_m2 / (2.0 * 8000.0 - both_m2), 0.02);
}

TEST(WriteOrientationMap, NeedsAnImageThatSeesTheGround) {
  const TempFolder folder;
  EXPECT_THAT(
      io_error_of([&] { write_orientation_map(folder.file("plan.gpkg"), vertical_pair(), 500.0); }),
      HasSubstr("has no footprint"));
  EXPECT_EQ(folder.num_files(), 0U);
}

}  // namespace
}  // namespace ridgeline::io
