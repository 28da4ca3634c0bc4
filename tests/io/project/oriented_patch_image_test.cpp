// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/oriented_patch_image.h"

#include "io/orientation/read_orientation.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>

#include <array>
#include <stdexcept>

namespace ridgeline::io {
namespace {

constexpr double kSamePixel_px = 1e-9;

Orientation oriented_fixture() {
  return read_orientation(test::source_dir() +
                          "/tests/io/orientation/fixtures/metashape_local.xml");
}

TEST(OrientedPatchImage, ProjectsAsTheOrientation) {
  const Orientation orientation = oriented_fixture();
  const Eigen::Vector3d middle(500321.0, 5412345.0, 6.0);
  for (const OrientedImage& image : orientation.images) {
    const PatchImage made = oriented_patch_image(orientation, image, "frames/x.tif");
    const InteriorOrientation& interior = orientation.cameras[*image.camera].interior;
    EXPECT_EQ(made.path, "frames/x.tif");
    ASSERT_TRUE(made.interior.has_value());
    for (const double offset_m : {0.0, 11.0, 23.0}) {
      const Eigen::Vector3d x = middle + Eigen::Vector3d(offset_m, -0.5 * offset_m, 0.2 * offset_m);
      const Eigen::Vector2d ideal = project(made.image_from_world, x);
      const Eigen::Vector2d seen =
          distorted_px(interior, project(projection_matrix(interior, image.exterior), x));
      EXPECT_LT((distorted_px(*made.interior, ideal) - seen).norm(), kSamePixel_px);
      // the patch takes the distortion away again
      EXPECT_LT((undistorted_px(made, seen).value() - ideal).norm(), kSamePixel_px);
    }
  }
}

TEST(OrientedPatchImage, TakesItsIdFromTheNameOfTheFile) {
  const Orientation orientation = oriented_fixture();
  EXPECT_EQ(oriented_patch_image(orientation, orientation.images[0], "x").id, "a b_1");
}

TEST(OrientedPatchImage, NeedsACamera) {
  Orientation orientation = oriented_fixture();
  orientation.images[0].camera.reset();
  EXPECT_THROW((void)oriented_patch_image(orientation, orientation.images[0], "x"),
               std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::io
