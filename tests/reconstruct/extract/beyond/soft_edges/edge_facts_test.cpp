// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/beyond/soft_edges/edge_facts.h"

#include "tests/reconstruct/extract/ok2011/blurred_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

constexpr double kNoise = 0.01;

/// A view of large rectangles with their true sides as segments.
View view_of(double blur_px, double scale_px) {
  constexpr int kCell_px = 240;
  test::Random random(5);
  cv::Mat image(2 * kCell_px, 3 * kCell_px, CV_64FC3, test::kGround);
  std::vector<Segment2> edges;
  for (int y = kCell_px / 2; y < image.rows; y += kCell_px) {
    for (int x = kCell_px / 2; x < image.cols; x += kCell_px) {
      test::Rectangle roof = test::random_rectangle({x, y}, 0.2, random);
      roof.half_length_px = 90.0;
      roof.half_width_px = 60.0;
      test::draw(roof, blur_px, image);
      test::add_edges(roof, edges);
    }
  }
  View view;
  image.convertTo(view.image, CV_32F);
  for (auto& pixel : cv::Mat_<cv::Vec3f>(view.image))
    for (int band = 0; band < 3; ++band) pixel[band] += static_cast<float>(random.normal(kNoise));
  for (const Segment2& edge : edges) {
    EdgeSegment& segment = view.segments.emplace_back();
    segment.in_image = edge;
    segment.scale_px = scale_px;
  }
  return view;
}

TEST(EdgeFacts, WidthIsTheBlurInPixelsOfTheImageAtEveryScale) {
  constexpr double kTolerance = 0.1;  // steps of the blur, and the blocks of reduced images
  for (const auto& [blur_px, scale_px] :
       {std::pair(0.8, 1), std::pair(1.2, 1), std::pair(2.0, 2), std::pair(4.0, 4)}) {
    const EdgeFacts facts = edge_facts(view_of(blur_px, scale_px));
    ASSERT_EQ(facts.scales.size(), 1U);
    const EdgesOfScale& edges = facts.scales[0];
    EXPECT_EQ(edges.scale_px, scale_px);
    EXPECT_EQ(edges.n_segments, 24U);
    EXPECT_NEAR(edges.length_px, 12 * (180.0 + 120.0), 1e-6);
    const double of_blocks_px = (scale_px - 1) * std::sqrt(1.0 / 12.0);
    ASSERT_TRUE(edges.width_px);
    EXPECT_NEAR(*edges.width_px, std::hypot(blur_px, of_blocks_px), kTolerance * blur_px + 0.05)
        << blur_px;
  }
}

TEST(EdgeFacts, NoiseIsThatOfGrey) {
  constexpr double kTolerance = 0.05;  // few pixels lie on edges
  const double of_grey = kNoise / std::sqrt(3.0);
  View view = view_of(1.0, 1);
  EXPECT_NEAR(edge_facts(view).noise.value(), of_grey, kTolerance * of_grey);
  view.is_valid =
      cv::Mat(view.image.size(), CV_8UC1, cv::Scalar(255));  // black where there is no data
  const cv::Rect left(0, 0, view.image.cols * 2 / 3, view.image.rows);
  view.is_valid(left) = 0;
  view.image(left) = 0;
  EXPECT_NEAR(edge_facts(view).noise.value(), of_grey, kTolerance * of_grey);
  view.is_valid = 0;
  EXPECT_FALSE(edge_facts(view).noise);
}

TEST(EdgeFacts, AreNoWidthOfFewEdges) {
  View view = view_of(1.0, 1);
  view.segments.resize(4);
  EXPECT_FALSE(edge_facts(view).scales.at(0).width_px);
}

TEST(EdgeFacts, AreNoScalesWithoutSegments) {
  View view = view_of(1.0, 1);
  view.segments.clear();
  EXPECT_TRUE(edge_facts(view).scales.empty());
}

}  // namespace
}  // namespace ridgeline::reconstruct
