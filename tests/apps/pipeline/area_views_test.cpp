// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/area_views.h"

#include <Eigen/Dense>
#include <gmock/gmock.h>

namespace ridgeline::apps {
namespace {

constexpr double kFlight_m = 1000.0;

/// A frame of 4000 x 3000 pixels of 0.1 m at height 0, taken from above a place, tilted a little.
io::PatchImage frame_above(const std::string& id, double x_m, double y_m) {
  constexpr double kTilt_rad = 0.01;
  io::PatchImage image;
  image.id = id;
  image.interior =
      InteriorOrientation{{10000.0, 10000.0}, {1999.5, 1499.5}, {}, Eigen::Vector2i(4000, 3000)};
  image.image_from_world = projection_matrix(
      *image.interior, {{x_m, y_m, kFlight_m}, world_from_camera_axes(kTilt_rad, -kTilt_rad, 0.3)});
  return image;
}

SearchedPlace searched_place() {
  return {{{4000.0, 5000.0}, {4060.0, 5000.0}, {4060.0, 5050.0}, {4000.0, 5050.0}}, {0.0, 30.0}};
}

/// Whether the window holds what the image shows of the area, with 32 px around it or the border of
/// the frame.
void expect_holds_area(const io::Window& window,
                       const SearchedPlace& place,
                       const io::PatchImage& image) {
  Eigen::AlignedBox2d shown;
  for (const Eigen::Vector2d& corner : place.area_m) {
    for (const double z : place.height_range_m) {
      Eigen::Vector2d x =
          (image.image_from_world * Eigen::Vector4d(corner.x(), corner.y(), z, 1.0)).hnormalized();
      if (!image.interior->distortion.is_zero()) x = distorted_px(*image.interior, x);
      shown.extend(x);
    }
  }
  EXPECT_NEAR(window.column, shown.min().x() - 32.0, 1.0);
  EXPECT_NEAR(window.row, shown.min().y() - 32.0, 1.0);
  EXPECT_NEAR(window.column + window.width, shown.max().x() + 32.0, 1.0);
  EXPECT_NEAR(window.row + window.height, shown.max().y() + 32.0, 1.0);
}

TEST(WindowOfArea, HoldsTheAreaAtAllHeightsAndNoMore) {
  const SearchedPlace place = searched_place();
  io::PatchImage image = frame_above("a", 4050.0, 5000.0);
  const Eigen::Vector2i size(4000, 3000);
  expect_holds_area(window_of_area(place, image, size).value(), place, image);
  image.interior->distortion.k1 = -0.3;  // moves pixels by up to 8 here
  expect_holds_area(window_of_area(place, image, size).value(), place, image);
}

TEST(WindowOfArea, EndsAtTheBorderOfTheFrame) {
  const SearchedPlace place = searched_place();
  const Eigen::Vector2i size(4000, 3000);
  const io::Window window = window_of_area(place, frame_above("a", 4200.0, 5000.0), size).value();
  EXPECT_EQ(window.column, 0);
  EXPECT_GT(window.width, 10);
  EXPECT_FALSE(window_of_area(place, frame_above("b", 4600.0, 5000.0), size));
}

TEST(BestImages, AreThoseThatShowTheAreaTheBaseFirst) {
  const std::vector<io::PatchImage> images{frame_above("far", 7000.0, 5000.0),
                                           frame_above("counterpart", 4130.0, 5020.0),
                                           frame_above("base", 4030.0, 5030.0)};
  const std::vector<io::PatchImage> best =
      best_images(images, io::kDefaultMaxViews, searched_place());
  ASSERT_EQ(best.size(), 2U);
  EXPECT_EQ(best[0].id, "base");
  EXPECT_EQ(best[1].id, "counterpart");
}

TEST(ImagesThatShow, AreThoseThatShowTheArea) {
  const std::vector<io::PatchImage> lost = images_that_show(
      searched_place(), {frame_above("far", 7000.0, 5000.0), frame_above("lost", 4130.0, 5020.0)});
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost[0].id, "lost");
}

}  // namespace
}  // namespace ridgeline::apps
