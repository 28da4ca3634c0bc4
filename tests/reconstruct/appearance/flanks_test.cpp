// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/appearance/flanks.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

constexpr float kFlankRounding = 1e-6F;

/// Dark above row 20, bright from there on.
cv::Mat dark_above_bright() {
  cv::Mat image(40, 40, CV_32FC3, cv::Scalar(0.1, 0.2, 0.3));
  image.rowRange(20, 40).setTo(cv::Scalar(0.7, 0.8, 0.9));
  return image;
}

TEST(Flanks, RightIsBelowALineThatRunsToTheRight) {
  const auto [left, right] = flanks(dark_above_bright(), {{10, 19.5}, {30, 19.5}});
  EXPECT_NEAR(left.colour[0], 0.1F, kFlankRounding);
  EXPECT_NEAR(left.colour[3], 0.0F, kFlankRounding);
  EXPECT_NEAR(left.grey, 0.2F, kFlankRounding);
  EXPECT_NEAR(right.colour[2], 0.9F, kFlankRounding);
  EXPECT_NEAR(right.grey, 0.8F, kFlankRounding);
}

TEST(Flanks, LeaveOutWhatIsBeyondTheImage) {
  const auto [left, right] = flanks(dark_above_bright(), {{10, 39}, {30, 39}});
  EXPECT_NEAR(left.grey, 0.8F, kFlankRounding);
  EXPECT_EQ(right.grey, 0.0F);
}

TEST(Flanks, OfASoftEdgeAreFartherAway) {
  cv::Mat image = dark_above_bright();
  image.rowRange(20, 23).setTo(cv::Scalar(0.4, 0.4, 0.4));
  const Segment2 edge{{10, 19.5}, {30, 19.5}};
  EXPECT_LT(flanks(image, edge)[1].grey, 0.7F);
  EXPECT_NEAR(flanks(image, edge, 3.0)[1].grey, 0.8F, kFlankRounding);
}

TEST(SetFlanks, TurnsASegmentWithItsBrighterSideOnTheLeft) {
  EdgeSegment segment;
  segment.in_image = {{30, 19.5}, {10, 19.5}};
  segment.line.segment = {{31, 19.5}, {11, 19.5}};
  set_flanks(dark_above_bright(), segment);
  EXPECT_EQ(segment.in_image.start.x(), 10.0);
  EXPECT_EQ(segment.line.segment.end.x(), 31.0);
  EXPECT_NEAR(segment.left.grey, 0.2F, kFlankRounding);
  EXPECT_NEAR(segment.right.grey, 0.8F, kFlankRounding);
}

}  // namespace
}  // namespace ridgeline::reconstruct
