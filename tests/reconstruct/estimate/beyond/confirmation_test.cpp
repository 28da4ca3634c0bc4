// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/confirmation.h"

#include "reconstruct/geometry/orientation.h"
#include "tests/reconstruct/support/stereo_scene.h"

#include <gtest/gtest.h>

#include <limits>

namespace ridgeline::reconstruct {
namespace {

constexpr int kWindow_px = 400;
const Segment3 kLine{{-3.0, 1.0, 0.0}, {3.0, 2.0, 0.0}};

/// Three views of the origin: the stereo scene and its left view again.
Scene three_views() {
  const test::StereoScene stereo;
  Scene scene;
  for (const std::size_t camera : {0U, 1U, 0U}) {
    const ProjectionMatrix& whole = stereo.cameras[camera];
    const Eigen::Vector2d middle = project(whole, Eigen::Vector3d(0.0, 0.0, 0.0));
    View& view = scene.views.emplace_back();
    view.image_from_local =
        window_from_world(whole, middle - Eigen::Vector2d::Constant(0.5 * kWindow_px));
    view.image = cv::Mat(kWindow_px, kWindow_px, CV_32F);
  }
  scene.height_range_in_local_m = {-10.0, 30.0};
  return scene;
}

/// The surface of the first two views at one height, everywhere.
Surface level_at(const Scene& scene, double z_m) {
  const StereoPair pair = stereo_pair(scene, {0, 1});
  Surface surface;
  surface.rectification = *rectification(pair.cameras(), {kWindow_px, kWindow_px});
  const Rectification& r = surface.rectification;
  surface.disparity_px = cv::Mat(r.size, CV_32F);
  for (int row = 0; row < r.size.height; ++row) {
    for (int column = 0; column < r.size.width; ++column) {
      const Eigen::Vector3d near = r.point_in_local(Eigen::Vector2d(column, row), 1.0);
      const Eigen::Vector3d ray = near - r.left_centre_m;
      const Eigen::Vector3d x = r.left_centre_m + (z_m - r.left_centre_m.z()) / ray.z() * ray;
      surface.disparity_px.at<float>(row, column) = static_cast<float>(r.disparity_px(x));
    }
  }
  return surface;
}

bool is_pair_confirmed(const Scene& scene, std::span<const Surface* const> surfaces) {
  std::vector<ReconstructedLine> lines(1);
  lines[0].segment_in_local = kLine;
  lines[0].failure.reset();
  lines[0].observations = {{{0, 0}, {}}, {{1, 0}, {}}};
  mark_unconfirmed(scene, surfaces, lines);
  return lines[0].confirmed;
}

TEST(Confirmation, IsMissingWhereAThirdViewShouldShowTheLine) {
  EXPECT_FALSE(is_pair_confirmed(three_views(), {}));
}

TEST(Confirmation, IsNotAskedOfAViewBesideTheLine) {
  Scene scene = three_views();
  scene.views[2].image =
      cv::Mat(kWindow_px / 2, kWindow_px / 2, CV_32F);  // the line is in the middle
  EXPECT_TRUE(is_pair_confirmed(scene, {}));
}

TEST(Confirmation, IsNotAskedOfAViewThatASurfaceHidesTheLineFrom) {
  const Scene scene = three_views();
  const Surface above = level_at(scene, 6.0);
  const Surface at = level_at(scene, 0.0);
  const Surface* const hides = &above;
  const Surface* const bears = &at;
  EXPECT_TRUE(is_pair_confirmed(scene, {&hides, 1}));
  EXPECT_FALSE(is_pair_confirmed(scene, {&bears, 1}));
}

TEST(Confirmation, IsThereForLinesOfThreeViewsAndLinesWithoutAPlace) {
  const Scene scene = three_views();
  std::vector<ReconstructedLine> lines(2);
  lines[0].segment_in_local = kLine;
  lines[0].failure.reset();
  lines[0].observations = {{{0, 0}, {}}, {{1, 0}, {}}, {{2, 0}, {}}};
  lines[1].observations = {{{0, 1}, {}}, {{1, 1}, {}}};
  mark_unconfirmed(scene, {}, lines);
  EXPECT_STREQ(status_name(lines[0]), "direct");
  EXPECT_STREQ(status_name(lines[1]), "no_intersection");
}

}  // namespace
}  // namespace ridgeline::reconstruct
