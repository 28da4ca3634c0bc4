// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/beyond/close_edges/close_edges.h"

#include "reconstruct/extract/ok2011/edge_blur.h"
#include "tests/reconstruct/extract/ok2011/blurred_strip.h"

#include <gmock/gmock.h>

#include <utility>

namespace ridgeline::reconstruct {
namespace {

using test::BlurredStrip;

/// The image has single precision.
constexpr double kExact_px = 1e-4;

std::optional<std::array<ProfileStep, 2>> find(const BlurredStrip& strip, const Segment2& segment) {
  return CloseEdgeFinder(strip.blur_px).find(strip.image(), segment);
}

Segment2 moved(const Segment2& s, double across_px) {
  const Eigen::Vector2d along = (s.end - s.start).normalized();
  const Eigen::Vector2d by = across_px * Eigen::Vector2d(-along.y(), along.x());
  return {s.start + by, s.end + by};
}

TEST(CloseEdges, FindsBothBordersOfAStripThatBlursIntoOneEdge) {
  BlurredStrip strip;
  strip.offsets_px = {-0.6, 0.7};
  const auto edges = find(strip, strip.base_segment());
  ASSERT_TRUE(edges);
  EXPECT_NEAR((*edges)[0].offset_px, -0.6, kExact_px);
  EXPECT_NEAR((*edges)[1].offset_px, 0.7, kExact_px);
  // the height is the root of the summed squares of the steps of the bands
  EXPECT_NEAR((*edges)[0].height, std::sqrt(0.4 * 0.4 + 0.2 * 0.2 + 0.35 * 0.35), kExact_px);
}

TEST(CloseEdges, FindsBothBordersOfALineOfHalfAPixel) {
  BlurredStrip strip;
  strip.offsets_px = {-0.9, -0.4};
  const auto edges = find(strip, strip.base_segment());
  ASSERT_TRUE(edges);
  EXPECT_NEAR((*edges)[0].offset_px, -0.9, kExact_px);
  EXPECT_NEAR((*edges)[1].offset_px, -0.4, kExact_px);
}

TEST(CloseEdges, TellsOffsetsFromTheSegmentThatIsGiven) {
  const BlurredStrip strip;
  const auto edges = find(strip, moved(strip.base_segment(), 0.4));
  ASSERT_TRUE(edges);
  EXPECT_NEAR((*edges)[0].offset_px, -0.75 - 0.4, kExact_px);
  EXPECT_NEAR((*edges)[1].offset_px, 0.75 - 0.4, kExact_px);
}

TEST(CloseEdges, FollowsAStripThatWidens) {
  BlurredStrip strip;
  strip.offsets_px = {-0.8, 0.6};
  strip.tilts_px = {-0.3, 0.4};
  const auto edges = find(strip, strip.base_segment());
  ASSERT_TRUE(edges);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR((*edges)[i].offset_px, strip.offsets_px[i], kExact_px);
    EXPECT_NEAR((*edges)[i].tilt_px, strip.tilts_px[i], kExact_px);
  }
}

TEST(CloseEdges, AStripIsFoundToAFewHundredthsOfAPixelInNoise) {
  constexpr double kTolerance_px = 0.05;  // three standard deviations, found by repetition
  BlurredStrip strip;
  strip.noise = 0.02;
  const auto edges = find(strip, strip.base_segment());
  ASSERT_TRUE(edges);
  EXPECT_NEAR((*edges)[0].offset_px, -0.75, kTolerance_px);
  EXPECT_NEAR((*edges)[1].offset_px, 0.75, kTolerance_px);
}

TEST(CloseEdges, FindsBothBordersOfAStripThatASoftImageShows) {
  BlurredStrip strip;
  strip.blur_px = 2.1;
  strip.offsets_px = {-1.3, 1.6};
  const auto edges = find(strip, strip.base_segment());
  ASSERT_TRUE(edges);
  EXPECT_NEAR((*edges)[0].offset_px, -1.3, kExact_px);
  EXPECT_NEAR((*edges)[1].offset_px, 1.6, kExact_px);
}

TEST(CloseEdges, AMarkingOfASoftImageIsFoundFromTheEdgeThatTheGradientShows) {
  constexpr double kTolerance_px = 0.4;  // half of what the width of so narrow a strip may be wrong
  BlurredStrip marking;
  marking.colours[2] = marking.colours[0];
  marking.blur_px = 3.0;
  marking.noise = 0.008;
  const double blur_moves_px = 3.0;  // a narrow strip has the strongest gradient there
  const auto edges = find(marking, moved(marking.base_segment(), blur_moves_px));
  ASSERT_TRUE(edges);
  EXPECT_NEAR((*edges)[0].offset_px, -0.75 - blur_moves_px, kTolerance_px);
  EXPECT_NEAR((*edges)[1].offset_px, 0.75 - blur_moves_px, kTolerance_px);
}

TEST(CloseEdges, LeavesASingleEdgeAlone) {
  BlurredStrip step;
  step.noise = 0.02;
  step.colours[1] = step.colours[2];
  EXPECT_FALSE(find(step, step.base_segment()));
}

TEST(CloseEdges, LeavesAnEdgeWithAnotherBlurAlone) {
  const CloseEdgeFinder finder(0.55);
  for (const double blur_px : {0.45, 0.55, 0.65}) {
    BlurredStrip step;
    step.colours[1] = step.colours[2];
    step.blur_px = blur_px;
    EXPECT_FALSE(finder.find(step.image(), step.base_segment())) << blur_px;
  }
  // a shadow has a soft edge, because the sun is no point
  BlurredStrip shadow;
  shadow.colours = {{{0.6, 0.6, 0.6}, {0.4, 0.4, 0.4}, {0.2, 0.2, 0.2}}};
  shadow.offsets_px = {-0.35, 0.35};
  EXPECT_FALSE(find(shadow, shadow.base_segment()));
}

TEST(CloseEdges, LeavesAnEdgeWithAnotherOneFartherAwayAlone) {
  BlurredStrip wide;
  wide.offsets_px = {0.0, 4.5};
  EXPECT_FALSE(find(wide, wide.base_segment()));
}

TEST(CloseEdges, LeavesAShortSegmentAlone) {
  const BlurredStrip strip;
  const Segment2 base = strip.base_segment();
  const Segment2 piece{base.start, base.start + 8.0 * (base.end - base.start).normalized()};
  EXPECT_FALSE(find(strip, piece));
}

TEST(CloseEdges, ASegmentWithoutLengthHasNone) {
  const BlurredStrip strip;
  const Segment2 base = strip.base_segment();
  EXPECT_FALSE(find(strip, {base.start, base.start}));
}

TEST(CloseEdges, TakesASegmentThatGoesOnBeyondTheImage) {
  const BlurredStrip strip;
  const Segment2 base = strip.base_segment();
  const Eigen::Vector2d quarter = 0.25 * (base.end - base.start);
  const auto edges = find(strip, {base.start - quarter, base.end + quarter});
  ASSERT_TRUE(edges);
  EXPECT_NEAR((*edges)[0].offset_px, -0.75, kExact_px);
}

TEST(EdgeBlur, IsThatOfCleanEdges) {
  constexpr double kGrid = 0.05;  // step of the blurs that are tried, in the unit of their profile
  for (const auto& [blur_px, unit_px] :
       {std::pair{0.5, 1.0}, {0.8, 1.0}, {1.1, 1.0}, {2.0, 2.0}, {4.0, 4.0}}) {
    BlurredStrip step;
    step.noise = 0.005;
    step.blur_px = blur_px;
    step.colours[1] = step.colours[0];
    step.offsets_px = {0.0, 0.1};
    const std::vector<Segment2> repeated(5, step.base_segment());
    EXPECT_NEAR(edge_blur_px(step.image(), repeated).value(), blur_px, kGrid * unit_px) << blur_px;
  }
}

TEST(EdgeBlur, IsTypicalWithoutCleanEdges) {
  const cv::Mat flat(60, 60, CV_32FC1, cv::Scalar(0.5));
  EXPECT_FALSE(edge_blur_px(flat, {}));
  const std::vector<Segment2> one(9, Segment2{{10.0, 30.0}, {50.0, 30.0}});
  EXPECT_FALSE(edge_blur_px(flat, one));
}

}  // namespace
}  // namespace ridgeline::reconstruct
