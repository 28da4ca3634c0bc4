// SPDX-License-Identifier: BSD-3-Clause
#include "io/gdal/surface_heights.h"

#include "io/error.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

namespace ridgeline::io {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

/// Cells of 2 m whose middles are at x = 101, 103, 105 and y = 205, 203, 201, from top to bottom.
constexpr const char* kGrid =
    "ncols 3\nnrows 3\nxllcorner 100\nyllcorner 200\ncellsize 2\nNODATA_value -9999\n"
    "1.5 2.5 3.5\n4.5 -9999 6.5\n7.5 8.5 9.5\n";

TEST(SurfaceHeights, AreThoseOfTheCellsWithinTheBounds) {
  const TempFolder folder;
  const std::string path = folder.write("dsm.asc", kGrid);
  const Eigen::AlignedBox2d right_top(Eigen::Vector2d(102.5, 202.5), Eigen::Vector2d(110, 210));
  EXPECT_THAT(read_surface_heights(path, right_top).heights_m, UnorderedElementsAre(2.5, 3.5, 6.5));
  const Eigen::AlignedBox2d bottom(Eigen::Vector2d(100.0, 200.0), Eigen::Vector2d(104.0, 202.0));
  EXPECT_THAT(read_surface_heights(path, bottom).heights_m, UnorderedElementsAre(7.5, 8.5));
}

TEST(SurfaceHeights, AreNoneOutsideOfTheModelAndInHoles) {
  const TempFolder folder;
  const std::string path = folder.write("dsm.asc", kGrid);
  const Eigen::AlignedBox2d beside(Eigen::Vector2d(0, 0), Eigen::Vector2d(50, 50));
  EXPECT_TRUE(read_surface_heights(path, beside).heights_m.empty());
  const Eigen::AlignedBox2d hole(Eigen::Vector2d(102.5, 202.5), Eigen::Vector2d(103.5, 203.5));
  EXPECT_TRUE(read_surface_heights(path, hole).heights_m.empty());
  EXPECT_EQ(read_surface_heights(path, hole).n_impossible, 0U);
  EXPECT_THROW((void)read_surface_heights(folder.file("missing.tif"), hole), MissingFileError);
}

TEST(SurfaceHeights, ThatNoSurfaceHasAreMissingAndCounted) {
  const TempFolder folder;
  const std::string path =
      folder.write("dsm.asc",
                   "ncols 3\nnrows 3\nxllcorner 100\nyllcorner 200\ncellsize 2\n"
                   "-9999 -32768 3.4e38\n-400.5 0 8848.0\n-600 nan 32767\n");
  const Eigen::AlignedBox2d all(Eigen::Vector2d(0, 0), Eigen::Vector2d(500, 500));
  const SurfaceHeights model = read_surface_heights(path, all);
  EXPECT_THAT(model.heights_m, UnorderedElementsAre(-400.5, 0.0, 8848.0));
  EXPECT_EQ(model.n_impossible, 5U);
}

/// Heights above the North American datum in US survey feet.
TEST(SurfaceHeights, AreInMetresWhateverTheUnitOfTheVerticalSystem) {
  const TempFolder folder;
  const std::string path = folder.write(
      "dsm.asc", "ncols 1\nnrows 1\nxllcorner 100\nyllcorner 200\ncellsize 2\n10000\n");
  const Eigen::AlignedBox2d all(Eigen::Vector2d(0, 0), Eigen::Vector2d(500, 500));
  EXPECT_EQ(read_surface_heights(path, all).n_impossible, 1U);
  (void)folder.write("dsm.prj", to_wkt({"EPSG:2263+6360"}));
  EXPECT_THAT(read_surface_heights(path, all).heights_m,
              ElementsAre(DoubleNear(10000.0 * kSurveyFoot_m, 1e-6)));
}

}  // namespace
}  // namespace ridgeline::io
