// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/profile_registration.h"

#include "tests/reconstruct/support/owned_pair.h"
#include "tests/reconstruct/support/stereo_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace ridgeline::reconstruct {
namespace {

constexpr int kSizePx = 400;
constexpr double kWidthM = 0.15;  // width of the marking, two pixels
constexpr double kBlurM = 0.05;
/// Error of the parabola through correlations an eighth of a pixel apart, and of bilinear
/// interpolation.
constexpr double kRegisteredPx = 0.035;

/// A blurred step of height 1.
double step(double s_m) { return 0.5 * std::erfc(-s_m / (kBlurM * std::numbers::sqrt2)); }

/// Colour at a distance across the marking from its first border.
using Paint = std::function<double(double s_m)>;
double marking(double s_m) { return 0.3 + 0.2 * (step(s_m) - step(s_m - kWidthM)); }
double roof_and_lawn(double s_m) { return 0.5 - 0.2 * step(s_m); }
/// A marking on level ground through the centre of both images.
class Marking {
 public:
  explicit Marking(double angle_deg,
                   const Paint& in_left = marking,
                   const Paint& in_right = marking)
      : border_(test::make_segment(
            scene_, {scene_.left_centre(), angle_deg * test::kDegree, 100.0, 0.0, 0.0})) {
    for (const std::size_t j : {0U, 1U}) {
      const Eigen::Vector2d centre = project(cameras_[j], Eigen::Vector3d::Zero().eval());
      for (const int axis : {0, 1}) {
        cameras_[j].row(axis) -= ((centre[axis] - kSizePx / 2.0) * cameras_[j].row(2)).eval();
      }
      images_[j].create(kSizePx, kSizePx, CV_32FC1);
      for (int y = 0; y < kSizePx; ++y) {
        for (int x = 0; x < kSizePx; ++x) {
          const Eigen::Vector3d on_ground = point_on_plane(cameras_[j], Eigen::Vector2d(x, y),
                                                           Plane3(Eigen::Vector3d::UnitZ(), 0.0));
          images_[j].at<float>(y, x) = static_cast<float>(
              (j == 0 ? in_left : in_right)(across().dot(on_ground - border_.start)));
        }
      }
    }
  }

  /// The first border, or a line beside it.
  [[nodiscard]] Segment3 line(double s_m = 0.0) const {
    return {border_.start + s_m * across(), border_.end + s_m * across()};
  }
  [[nodiscard]] Segment2 seen(std::size_t j, const Segment3& line) const {
    return project(cameras_[j], line);
  }
  void cut_right_image(int columns) { images_[1] = images_[1].colRange(0, columns); }

  [[nodiscard]] test::OwnedPair pair(const Segment3& in_left, const Segment3& in_right) const {
    return {{View{"left", cameras_[0], images_[0], {}, {edge(seen(0, in_left))}},
             View{"right", cameras_[1], images_[1], {}, {edge(seen(1, in_right))}}},
            {-10.0, 10.0}};
  }

  /// The profiles of a match whose segments show `in_left` in the left and `in_right` in the right
  /// image.
  [[nodiscard]] ComparedProfiles compared(const Segment3& in_left, const Segment3& in_right) const {
    return compare_profiles(pair(in_left, in_right), std::vector<Correspondence>{{0, 0}}, 10.0)
        .at(0);
  }
  [[nodiscard]] double shift_px(const Segment3& in_left, const Segment3& in_right) const {
    return compared(in_left, in_right).right_shift_px;
  }

 private:
  static EdgeSegment edge(const Segment2& s) {
    EdgeSegment edge;
    edge.in_image = s;
    edge.line = test::exact(s);
    return edge;
  }
  [[nodiscard]] Eigen::Vector3d across() const {
    return Eigen::Vector3d::UnitZ().cross(border_.end - border_.start).normalized();
  }

  test::StereoScene scene_;
  std::array<ProjectionMatrix, 2> cameras_ = scene_.cameras;
  std::array<cv::Mat, 2> images_;
  Segment3 border_;
};

Segment3 reversed(const Segment3& s) { return {s.end, s.start}; }

/// Distance of a point from the line of a segment along n = (-u_y, u_x).
double across_px(const Segment2& s, const Eigen::Vector2d& x) {
  const Eigen::Vector2d u = (s.end - s.start).normalized();
  return Eigen::Vector2d(-u.y(), u.x()).dot(x - s.start);
}

TEST(RegisteredShifts, BringTheRightSegmentToTheBorderThatTheLeftOneIsOn) {
  for (const double angle_deg : {25.0, 60.0, 90.0}) {
    const Marking scene(angle_deg);
    // the other border, and lines that the steps of the search miss
    for (const double s_m : {kWidthM, 0.11, 0.115, -0.12}) {
      const Segment3 beside = scene.line(s_m);
      for (const Segment3& in_right : {beside, reversed(beside)}) {
        const double expected =
            across_px(scene.seen(1, in_right), midpoint(scene.seen(1, scene.line())));
        ASSERT_GT(std::abs(expected), 1.0);
        EXPECT_NEAR(scene.shift_px(scene.line(), in_right), expected, kRegisteredPx) << angle_deg;
        EXPECT_NEAR(scene.shift_px(reversed(scene.line()), in_right), expected, kRegisteredPx);
      }
    }
  }
}

TEST(RegisteredShifts, AreNoneWhereTheSegmentsAreOnOneBorder) {
  const Marking scene(60.0);
  EXPECT_EQ(scene.shift_px(scene.line(), scene.line()), 0.0);
}

TEST(RegisteredShifts, AreNoneWhereTheImagesShowDifferentSurfaces) {
  const Marking scene(60.0, marking, roof_and_lawn);
  EXPECT_EQ(scene.shift_px(scene.line(), scene.line(kWidthM)), 0.0);
}

TEST(RegisteredShifts, AreNoneWhereTheMarkingIsTooFarAway) {
  const Marking scene(60.0);
  // the marking is a tenth of a pixel beyond the search, at whose end the profiles are nearly as
  // alike
  for (const double s_m : {0.207, -0.207}) {
    const double px =
        across_px(scene.seen(1, scene.line(s_m)), midpoint(scene.seen(1, scene.line())));
    ASSERT_GT(std::abs(px), 2.52);
    ASSERT_LT(std::abs(px), 2.7);
    EXPECT_EQ(scene.shift_px(scene.line(), scene.line(s_m)), 0.0);
  }
}

TEST(RegisteredShifts, AreNoneOfAlignedLines) {
  EXPECT_NE(Marking(12.0).shift_px(Marking(12.0).line(), Marking(12.0).line(kWidthM)), 0.0);
  const Marking scene(8.0);
  EXPECT_EQ(scene.shift_px(scene.line(), scene.line(kWidthM)), 0.0);
}

TEST(ComparedProfiles, AreAlikeWhereverTheSegmentsLieBesideTheSameSurfaces) {
  constexpr double kSameProfile = 0.9995;  // interpolation between pixels
  const Marking scene(60.0);
  for (const double s_m : {0.0, kWidthM, -0.12})
    EXPECT_GT(scene.compared(scene.line(), scene.line(s_m)).similarity, kSameProfile) << s_m;
}

TEST(ComparedProfiles, AreNotAlikeWhereTheImagesShowDifferentSurfaces) {
  const Marking scene(60.0, marking, roof_and_lawn);
  const auto similarity = scene.compared(scene.line(), scene.line()).similarity;
  ASSERT_TRUE(similarity);
  EXPECT_LT(*similarity, 0.9);
}

TEST(ComparedProfiles, AreNoneOfAlignedLinesAndAtTheBorder) {
  const Marking aligned(8.0);
  EXPECT_FALSE(aligned.compared(aligned.line(), aligned.line()).similarity);
  Marking cut(90.0);
  cut.cut_right_image(kSizePx / 2 + 2);
  EXPECT_FALSE(cut.compared(cut.line(), cut.line()).similarity);
}

TEST(RegisteredShifts, AreNoneWhereTheProfileLeavesTheImage) {
  Marking scene(90.0);
  const Segment3 other_border = scene.line(kWidthM);
  const Segment2 seen = scene.seen(1, other_border);
  const double column = std::max(seen.start.x(), seen.end.x());
  // the profile reaches 4.5 px
  scene.cut_right_image(static_cast<int>(column) + 7);
  EXPECT_NE(scene.shift_px(scene.line(), other_border), 0.0);
  scene.cut_right_image(static_cast<int>(column) + 4);
  EXPECT_EQ(scene.shift_px(scene.line(), other_border), 0.0);
}

}  // namespace
}  // namespace ridgeline::reconstruct
