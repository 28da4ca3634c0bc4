// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scene/reduced_view.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include <stdexcept>

namespace ridgeline::reconstruct {
namespace {

constexpr double kRounding_px = 1e-9;

/// The value of a pixel of the frame.
float ramp(int column, int row) { return static_cast<float>(3 * column + 7 * row); }

/// A window of a frame whose grey values are a ramp.
View window_at(const Eigen::Vector2i& corner_px, const cv::Size& size_px) {
  View view;
  view.corner_px = corner_px;
  view.image.create(size_px, CV_32F);
  for (int row = 0; row < size_px.height; ++row) {
    for (int column = 0; column < size_px.width; ++column)
      view.image.at<float>(row, column) = ramp(corner_px.x() + column, corner_px.y() + row);
  }
  view.image_from_local << 900.0, 10.0, -20.0, 40.0, -5.0, 880.0, 15.0, 60.0, 0.01, 0.02, -1.0,
      300.0;
  return view;
}

EdgeSegment some_edge() {
  EdgeSegment edge;
  edge.line = {{{10.0, 20.0}, {50.0, 80.0}}, {31.0, 48.0}, 0.1, 0.002, 1.0};
  edge.in_image = {{11.0, 21.0}, {51.0, 81.0}};
  edge.rms_px = 0.3;
  edge.contrast = 0.2;
  return edge;
}

TEST(ReducedView, HasTheMeansOfBlocks) {
  const View small = reduced(window_at({0, 0}, {10, 7}), 4);
  ASSERT_EQ(small.image.size(), cv::Size(2, 1));  // what fills no block is left out
  EXPECT_FLOAT_EQ(small.image.at<float>(0, 1), 3 * 5.5F + 7 * 1.5F);
}

TEST(ReducedView, OfTwoWindowsOfAFrameHasTheSameBlocks) {
  const View whole = reduced(window_at({0, 0}, {32, 32}), 4);
  const View part = reduced(window_at({5, 11}, {20, 16}), 4);
  ASSERT_EQ(part.corner_px, Eigen::Vector2i(2, 3));
  EXPECT_EQ(cv::norm(part.image, whole.image(cv::Rect({2, 3}, part.image.size())), cv::NORM_INF),
            0.0);
}

TEST(ReducedView, ShowsAPointInTheMiddleOfItsBlock) {
  const View view = window_at({5, 11}, {20, 16});
  const View small = reduced(view, 2);  // its first block begins at (1, 1)
  const Eigen::Vector3d point(1.0, 2.0, 3.0);
  const Eigen::Vector2d x = project(view.image_from_local, point);
  const Eigen::Vector2d expected = (x - Eigen::Vector2d(1.5, 1.5)) / 2.0;
  EXPECT_LT((project(small.image_from_local, point) - expected).norm(), kRounding_px);
}

TEST(ReducedView, RemovesTheSameDistortion) {
  View view = window_at({0, 0}, {32, 32});
  view.ideal_from_image = [](const Eigen::Vector2d& x) -> std::optional<Eigen::Vector2d> {
    if (x.x() > 20.0) return std::nullopt;
    return Eigen::Vector2d(x + 0.001 * x.squaredNorm() * Eigen::Vector2d::UnitY());
  };
  const View small = reduced(view, 4);
  const Eigen::Vector2d in_image(9.5, 13.5);
  const Eigen::Vector2d in_small(2.0, 3.0);
  const Eigen::Vector2d ideal = *view.ideal_from_image(in_image);
  EXPECT_LT((*small.ideal_from_image(in_small) - (ideal - Eigen::Vector2d(1.5, 1.5)) / 4.0).norm(),
            kRounding_px);
  EXPECT_FALSE(small.ideal_from_image({6.0, 3.0}));
}

TEST(ReducedView, HasNoDataWhereAPixelOfTheBlockHasNone) {
  View view = window_at({0, 0}, {8, 8});
  view.is_valid = cv::Mat(view.image.size(), CV_8UC1, cv::Scalar(255));
  view.is_valid.at<std::uint8_t>(1, 6) = 0;
  const View small = reduced(view, 4);
  EXPECT_EQ(cv::countNonZero(small.is_valid), 3);
  EXPECT_EQ(small.is_valid.at<std::uint8_t>(0, 1), 0);
}

TEST(ReducedView, GivesItsSegmentsBack) {
  View view = window_at({5, 11}, {120, 120});
  view.segments = {some_edge()};
  const View small = reduced(view, 4);
  const EdgeSegment& seen = small.segments.at(0);
  EXPECT_EQ(seen.scale_px, 0.25);
  EXPECT_EQ(seen.line.sigma_q_px, 0.1 / 4.0);
  EXPECT_EQ(seen.line.sigma_phi_rad, 0.002);
  EXPECT_EQ(seen.contrast, 0.8);
  const EdgeSegment back = in_pixels_of(view, 4, small.segments).at(0);
  EXPECT_LT((back.line.segment.end - some_edge().line.segment.end).norm(), kRounding_px);
  EXPECT_LT((back.in_image.start - some_edge().in_image.start).norm(), kRounding_px);
  EXPECT_EQ(back.scale_px, 1.0);
  EXPECT_LT((in_pixels_of(view, 4, seen.in_image).start - some_edge().in_image.start).norm(),
            kRounding_px);
}

TEST(ReducedView, WithoutABlockIsEmpty) {
  EXPECT_TRUE(reduced(window_at({1, 1}, {6, 6}), 4).image.empty());
  EXPECT_THROW(reduced(window_at({0, 0}, {6, 6}), 0), std::invalid_argument);
}

TEST(ScaleOfEdges, IsThatOfTheSharpestSegment) {
  View view = window_at({0, 0}, {64, 64});
  EXPECT_EQ(scale_of_edges(view), 1);
  view.segments = {some_edge(), some_edge()};
  view.segments[0].scale_px = 4.0;
  view.segments[1].scale_px = 2.0;
  EXPECT_EQ(scale_of_edges(view), 2);
  const View small = at_scale_of_edges(view);
  EXPECT_EQ(small.image.size(), cv::Size(32, 32));
  EXPECT_EQ(small.segments[0].scale_px, 2.0);
  EXPECT_EQ(small.segments[1].scale_px, 1.0);
}

}  // namespace
}  // namespace ridgeline::reconstruct
