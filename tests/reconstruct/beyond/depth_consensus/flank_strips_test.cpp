// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/depth_consensus/flank_strips.h"

#include "reconstruct/views/epipolar_overlap.h"
#include "tests/reconstruct/support/stereo_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr int kSizePx = 400;
constexpr double kReadPx = 1e-3;  // of values that rise by 1e-3 a pixel, in float

/// Cameras of the scene with a window about its centre in both images, whose two bands are x and y
/// in thousandths of a pixel.
struct Ramps {
  test::StereoScene scene;
  std::array<ProjectionMatrix, 2> cameras = scene.cameras;
  std::array<cv::Mat, 2> images;

  Ramps() {
    for (std::size_t j = 0; j < 2; ++j) {
      const Eigen::Vector2d centre = project(cameras[j], Eigen::Vector3d::Zero().eval());
      for (const int axis : {0, 1}) {
        cameras[j].row(axis) -= ((centre[axis] - kSizePx / 2.0) * cameras[j].row(2)).eval();
      }
      images[j].create(kSizePx, kSizePx, CV_32FC2);
      for (int y = 0; y < kSizePx; ++y) {
        for (int x = 0; x < kSizePx; ++x) {
          images[j].at<cv::Vec2f>(y, x) = {1e-3F * static_cast<float>(x),
                                           1e-3F * static_cast<float>(y)};
        }
      }
    }
  }

  [[nodiscard]] EdgeSegment segment(std::size_t j, const Segment3& line) const {
    EdgeSegment edge;
    edge.in_image = project(cameras[j], line);
    edge.line = test::exact(edge.in_image);
    return edge;
  }

  [[nodiscard]] FlankStrips strips(const Segment3& line,
                                   const std::array<double, 2>& heights_m = {0.0, 10.0}) const {
    const StereoPair pair{{MatchView{cameras[0], images[0], {segment(0, line)}},
                           MatchView{cameras[1], images[1], {segment(1, line)}}},
                          heights_m};
    return sample_flanks(pair, std::vector<LineMatch>{{0, 0}}, 10.0)[0];
  }

  /// 100 px along the epipolar line, from `x_px` of the left window.
  [[nodiscard]] Segment3 aligned(double x_px = 150.0, double length_px = 100.0) const {
    const Eigen::Vector2d centre = scene.left_centre();
    const Eigen::Vector2d u = scene.epipolar_direction(centre);
    const Eigen::Vector2d direction = u.x() < 0.0 ? Eigen::Vector2d(-u) : u;
    const Eigen::Vector2d start = centre + (x_px - kSizePx / 2.0) * direction;
    return {scene.at_height(start, 0.0), scene.at_height(start + length_px * direction, 0.0)};
  }
};

TEST(SampleFlanks, ReadsRowsOnBothSidesOfTheLine) {
  const Ramps ramps;
  const Segment3 line = ramps.aligned();
  const FlankStrip strip = ramps.strips(line).left;
  ASSERT_EQ(strip.n_along, 101);
  ASSERT_EQ(strip.n_bands, 2);
  const Segment2 seen = project(ramps.cameras[0], line);
  const Eigen::Vector2d u = (seen.end - seen.start).normalized();
  for (const std::size_t side : {0U, 1U}) {
    for (int row = 0; row < FlankStrip::kRows; ++row) {
      const double offset = (side == 0 ? 1.0 : -1.0) * (2.0 + row);
      const Eigen::Vector2d x = point_at(seen, 0.4) + offset * Eigen::Vector2d(-u.y(), u.x());
      EXPECT_NEAR(1e3 * strip.row(side, row, 0)[40], x.x(), kReadPx * 1e3) << row;
      EXPECT_NEAR(1e3 * strip.row(side, row, 1)[40], x.y(), kReadPx * 1e3) << row;
    }
  }
}

TEST(SampleFlanks, TheRightStripReachesWhereverTheHeightsMayShowTheLine) {
  const Ramps ramps;
  const Segment3 line = ramps.aligned();
  const FlankStrip right = ramps.strips(line, {-3.0, 8.0}).right;
  const Segment2 left = project(ramps.cameras[0], line);
  const Eigen::Vector2d along = right.axis.end - right.axis.start;
  for (const Eigen::Vector2d& end : {left.start, left.end}) {
    for (const double height_m : {-3.0, 8.0}) {
      const Eigen::Vector2d x = project(
          ramps.cameras[1],
          point_on_plane(ramps.cameras[0], end, Plane3(Eigen::Vector3d::UnitZ(), -height_m)));
      const double t = along.dot(x - right.axis.start) / along.squaredNorm();
      EXPECT_GT(t, -1e-6);
      EXPECT_LT(t, 1.0 + 1e-6);
    }
  }
  EXPECT_NEAR(along.norm() / (right.n_along - 1), FlankStrip::kRightStep_px, 0.01);
}

TEST(SampleFlanks, HasNoValuesOutsideOfTheImage) {
  const Ramps ramps;
  const FlankStrip right = ramps.strips(ramps.aligned(), {-60.0, 60.0}).right;
  EXPECT_TRUE(std::isnan(right.row(0, 0, 0)[0]));
  EXPECT_FALSE(std::isnan(right.row(0, 0, 0)[right.n_along / 2]));
}

TEST(SampleFlanks, TellsWhichEndsTheBorderOfTheImageCuts) {
  const Ramps ramps;
  EXPECT_EQ(ramps.strips(ramps.aligned()).left.is_cut, (std::array{false, false}));
  EXPECT_EQ(ramps.strips(ramps.aligned(1.0)).left.is_cut, (std::array{true, false}));
}

TEST(SampleFlanks, LeavesOutLinesAcrossTheEpipolarLine) {
  const Ramps ramps;
  const Segment3 along = ramps.aligned();
  const Segment3 across{along.start, along.start + Eigen::Vector3d(0.0, 8.0, 0.0)};
  EXPECT_EQ(ramps.strips(across).left.n_along, 0);
  EXPECT_EQ(ramps.strips(across).right.n_along, 0);
}

}  // namespace
}  // namespace ridgeline::reconstruct
