// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/edge_points.h"

#include "tests/reconstruct/match/ok2011/stereo_pair.h"

#include <gmock/gmock.h>

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr int kSize_px = 60;

/// A step of 0.5 across the line n . x = c, blurred by a Gaussian of one pixel.
cv::Mat blurred_step(const Eigen::Vector2d& normal, double c) {
  cv::Mat image(kSize_px, kSize_px, CV_32FC1);
  for (int row = 0; row < kSize_px; ++row) {
    for (int column = 0; column < kSize_px; ++column) {
      const double d = normal.dot(Eigen::Vector2d(column, row)) - c;
      image.at<float>(row, column) = static_cast<float>(0.25 + 0.25 * std::erf(d / M_SQRT2));
    }
  }
  return image;
}

TEST(EdgePoints, FindTheStepBesideTheSegmentToAFractionOfAPixel) {
  const Eigen::Vector2d normal(-std::sin(0.3), std::cos(0.3));
  const Eigen::Vector2d along(normal.y(), -normal.x());
  const double c = 20.37;
  const cv::Mat image = blurred_step(normal, c);
  const Eigen::Vector2d start = c * normal + 12.0 * along;
  // the segment lies 0.6 px beside the edge
  const EdgeSegment edge = test::edge({start + 0.6 * normal, start + 30.3 * along + 0.6 * normal});
  const std::vector<EdgePoint> points = edge_points(ImageSampler(image), edge);
  ASSERT_EQ(points.size(), 30U);
  // bilinear samples of a step blurred by a pixel: measured worst 0.07 px
  for (const EdgePoint& point : points) EXPECT_NEAR(normal.dot(point.x_px), c, 0.1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].step, static_cast<int>(i));
    EXPECT_NEAR(along.dot(points[i].x_px - start), 1.01 * (0.5 + static_cast<double>(i)), 1e-9);
  }
}

TEST(EdgePoints, AreIdealWhereTheSegmentIsIdeal) {
  const cv::Mat image = blurred_step(Eigen::Vector2d::UnitY(), 30.0);
  EdgeSegment edge = test::edge({{10.0, 30.0}, {40.0, 30.0}});
  const Eigen::Vector2d shift(3.0, -5.0);  // as a lens would shift it
  edge.line.segment = {edge.in_image.start + shift, edge.in_image.end + shift};
  const std::vector<EdgePoint> points = edge_points(ImageSampler(image), edge);
  ASSERT_EQ(points.size(), 30U);
  for (const EdgePoint& point : points) {
    EXPECT_NEAR(point.x_px.y(), 25.0, 0.1);
    EXPECT_GT(point.x_px.x(), 13.0);
    EXPECT_LT(point.x_px.x(), 43.0);
  }
}

TEST(EdgePoints, LeaveOutStepsWithoutAnEdgeAndAtTheBorder) {
  const cv::Mat flat(kSize_px, kSize_px, CV_32FC1, cv::Scalar(0.5));
  EXPECT_TRUE(edge_points(ImageSampler(flat), test::edge({{10, 10}, {40, 30}})).empty());
  const cv::Mat image = blurred_step(Eigen::Vector2d::UnitY(), 1.0);
  EXPECT_TRUE(edge_points(ImageSampler(image), test::edge({{10, 1}, {40, 1}})).empty());
  // an edge 3 px away from the segment is another one
  const cv::Mat other = blurred_step(Eigen::Vector2d::UnitY(), 33.0);
  EXPECT_TRUE(edge_points(ImageSampler(other), test::edge({{10, 30}, {40, 30}})).empty());
}

}  // namespace
}  // namespace ridgeline::reconstruct
