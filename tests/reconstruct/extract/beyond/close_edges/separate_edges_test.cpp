// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/beyond/close_edges/separate_edges.h"

#include "reconstruct/extract/beyond/extensions.h"
#include "reconstruct/extract/ok2011/extract_segments.h"
#include "tests/reconstruct/extract/ok2011/blurred_strip.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

std::vector<EdgeSegment> extract_close(const cv::Mat& image,
                                       const EdgeExtensionOptions& beyond = {}) {
  return extract_segments(image, {}, {}, edge_refinement({{}, beyond}));
}

using test::BlurredStrip;

/// Offsets of the segments' middles from the strip's base line, ascending.
std::vector<double> offsets_px(const BlurredStrip& strip,
                               const std::vector<EdgeSegment>& segments) {
  const Segment2 base = strip.base_segment();
  const Eigen::Vector2d along = (base.end - base.start).normalized();
  const Eigen::Vector2d normal(-along.y(), along.x());
  std::vector<double> offsets;
  for (const EdgeSegment& s : segments) {
    offsets.push_back(normal.dot(s.line.centroid_px - base.start));
  }
  std::sort(offsets.begin(), offsets.end());
  return offsets;
}

/// A marking: bright between two stretches of the same dark.
BlurredStrip double_edge(double width_px) {
  BlurredStrip strip;
  strip.offsets_px = {-0.5 * width_px, 0.5 * width_px};
  strip.colours[2] = strip.colours[0];
  strip.noise = 0.005;
  return strip;
}

TEST(SeparateEdges, BothBordersOfAMarkingAreWhereTheyAreAndEachIsThereOnce) {
  constexpr double kTolerance_px =
      0.1;  // the maxima of the gradient lie 0.3 px outside of both borders
  const BlurredStrip strip = double_edge(1.5);
  const auto segments = extract_close(strip.image());
  EXPECT_THAT(offsets_px(strip, segments),
              testing::ElementsAre(testing::DoubleNear(-0.75, kTolerance_px),
                                   testing::DoubleNear(0.75, kTolerance_px)));
}

TEST(SeparateEdges, WithoutItTheBordersAreTooFarApart) {
  const BlurredStrip strip = double_edge(1.5);
  EdgeExtensionOptions options;
  options.separate_edges = false;
  const std::vector<double> offsets = offsets_px(strip, extract_close(strip.image(), options));
  ASSERT_EQ(offsets.size(), 2U);
  EXPECT_GT(offsets[1] - offsets[0], 1.9);
}

TEST(SeparateEdges, AStaircaseThatIsOneMaximumOfTheGradientBecomesTwoEdges) {
  constexpr double kTolerance_px = 0.1;
  BlurredStrip strip;
  strip.offsets_px = {-0.7, 0.7};
  strip.colours = {{{0.2, 0.2, 0.2}, {0.45, 0.4, 0.42}, {0.65, 0.7, 0.6}}};
  strip.noise = 0.005;
  EdgeExtensionOptions as_one;
  as_one.separate_edges = false;
  EXPECT_EQ(extract_close(strip.image(), as_one).size(), 1U);
  EXPECT_THAT(offsets_px(strip, extract_close(strip.image())),
              testing::ElementsAre(testing::DoubleNear(-0.7, kTolerance_px),
                                   testing::DoubleNear(0.7, kTolerance_px)));
}

}  // namespace
}  // namespace ridgeline::reconstruct
