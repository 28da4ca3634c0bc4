// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/own_segments.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <optional>

namespace ridgeline::reconstruct {
namespace {

EdgeSegment own_segment(const Eigen::Vector2d& start, const Eigen::Vector2d& end) {
  EdgeSegment segment;
  segment.in_image = {start, end};
  segment.line.sigma_q_px = 0.25;
  return segment;
}

/// A view that is bright in its left half.
View bright_on_the_left() {
  View view;
  view.image = cv::Mat(100, 100, CV_32FC1, cv::Scalar(0.2));
  view.image.colRange(0, 50).setTo(0.8);
  return view;
}

TEST(OwnSegments, GetLineFlanksAndDirectionFromTheView) {
  View view = bright_on_the_left();
  view.ideal_from_image = [](const Eigen::Vector2d& x) -> std::optional<Eigen::Vector2d> {
    return x + Eigen::Vector2d(3.0, 0.0);
  };
  view.own_segments = {{own_segment({49.5, 10.0}, {49.5, 80.0})}};
  const std::vector<EdgeSegment> segments = completed_own_segments(view);
  ASSERT_EQ(segments.size(), 1U);
  const EdgeSegment& segment = segments[0];
  EXPECT_EQ(segment.in_image.start, Eigen::Vector2d(49.5, 10.0));
  EXPECT_EQ(segment.line.segment.end, Eigen::Vector2d(52.5, 80.0));
  EXPECT_EQ(segment.line.centroid_px, Eigen::Vector2d(52.5, 45.0));
  EXPECT_EQ(segment.line.sigma_q_px, 0.25);
  EXPECT_FLOAT_EQ(segment.right.grey, 0.8F);
  EXPECT_FLOAT_EQ(segment.left.grey, 0.2F);
}

TEST(OwnSegments, AreLeftOutBesideNoDataAndWhereTheDistortionIsUnknown) {
  View view = bright_on_the_left();
  view.is_valid = cv::Mat(100, 100, CV_8UC1, cv::Scalar(255));
  view.is_valid.colRange(0, 20).setTo(0);
  view.ideal_from_image = [](const Eigen::Vector2d& x) {
    return x.x() < 90.0 ? std::optional(x) : std::nullopt;
  };
  view.own_segments = {{own_segment({20.5, 10.0}, {20.5, 80.0}),
                        own_segment({60.0, 50.0}, {95.0, 50.0}),
                        own_segment({60.0, 50.0}, {85.0, 50.0})}};
  const std::vector<EdgeSegment> segments = completed_own_segments(view);
  ASSERT_EQ(segments.size(), 1U);
  EXPECT_EQ(std::max(segments[0].in_image.start.x(), segments[0].in_image.end.x()), 85.0);
}

}  // namespace
}  // namespace ridgeline::reconstruct
