// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/guided_matches/guided_matches.h"

#include "reconstruct/appearance/flanks.h"
#include "tests/reconstruct/support/painted_roofs.h"

#include <gtest/gtest.h>

#include <utility>

namespace ridgeline::reconstruct {
namespace {

const Eigen::AlignedBox2d kHouse(Eigen::Vector2d(-6.0, -5.0), Eigen::Vector2d(6.0, 5.0));
constexpr double kHeight_m = 6.0;
const Segment3 kEave{{6.0, -4.5, kHeight_m}, {6.0, 4.5, kHeight_m}};
constexpr double kStep_px = 0.5;  // the scene is sampled, not blurred: edges lie between pixels

/// A bright roof whose eave is extracted in neither view to begin with.
struct BrightRoof {
  test::PaintedRoofs roofs{
      .faces = {{.plan = kHouse, .height_m = kHeight_m, .contrast = 0.4, .brighter = 0.3}},
      .ground_contrast = 0.4};
  test::OwnedPair pair = roofs.pair();
  std::optional<Surface> surface = dense_surface(pair);
};

/// Its images and its surface, which take most of the time, are made once.
const BrightRoof& bright_roof() {
  static const BrightRoof roof;
  return roof;
}

class GuidedMatchesTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(surface); }

  [[nodiscard]] EdgeSegment seen(std::size_t view, double aside_px = 0.0) const {
    const ProjectionMatrix& camera = pair.views[view].image_from_local;
    Segment2 line{project(camera, kEave.start), project(camera, kEave.end)};
    const Eigen::Vector2d aside = aside_px * normal(line);
    line = {line.start + aside, line.end + aside};
    auto sides = flanks(pair.views[view].image, line);
    if (sides[0].grey > sides[1].grey) {
      std::swap(line.start, line.end);
      std::swap(sides[0], sides[1]);
    }
    EdgeSegment segment;
    segment.line = {line, midpoint(line), 0.1, 0.001, 1.0};
    segment.in_image = line;
    segment.left = sides[0];
    segment.right = sides[1];
    segment.n_edge_pixels = static_cast<int>(length(line));
    return segment;
  }

  [[nodiscard]] GuidedMatches found(std::span<const Correspondence> known = {}) const {
    return guided_matches(pair, *surface, known, {});
  }

  test::OwnedPair pair = bright_roof().pair;
  const std::optional<Surface>& surface = bright_roof().surface;
};

TEST_F(GuidedMatchesTest, FindTheCounterpartThatTheOtherViewLacks) {
  for (const std::size_t guide : {0U, 1U}) {
    pair.views[guide].segments = {seen(guide)};
    pair.views[1 - guide].segments.clear();
    const GuidedMatches guided = found();
    ASSERT_EQ(guided.matches.size(), 1U) << guide;
    EXPECT_EQ(guided.matches[0].segments(), (std::pair{0, 0}));
    ASSERT_EQ(guided.counterparts[1 - guide].size(), 1U);
    EXPECT_TRUE(guided.counterparts[guide].empty());
    const EdgeSegment& counterpart = guided.counterparts[1 - guide][0];
    EXPECT_TRUE(counterpart.guided);
    const Segment2 truth = seen(1 - guide).line.segment;
    EXPECT_LT(distance(truth, counterpart.line.segment.start), kStep_px);
    EXPECT_LT(distance(truth, counterpart.line.segment.end), kStep_px);
    EXPECT_GT(length(counterpart.line.segment), 0.75 * length(truth));
  }
}

TEST_F(GuidedMatchesTest, LeaveMatchedSegmentsAlone) {
  pair.views[0].segments = {seen(0)};
  pair.views[1].segments = {seen(1, 30.0)};
  EXPECT_TRUE(found(std::array{Correspondence{0, 0}}).matches.empty());
}

TEST_F(GuidedMatchesTest, AreNotWhereASegmentIsAlready) {
  pair.views[0].segments = {seen(0)};
  pair.views[1].segments = {seen(1)};
  EXPECT_TRUE(found().matches.empty());
}

TEST_F(GuidedMatchesTest, CountTheirCounterpartsAfterThePairsSegments) {
  pair.views[0].segments = {seen(0)};
  pair.views[1].segments = {seen(1, 30.0)};
  const GuidedMatches guided = found();
  ASSERT_EQ(guided.matches.size(), 1U);
  EXPECT_EQ(guided.matches[0].segments(), (std::pair{0, 1}));
}

TEST_F(GuidedMatchesTest, AreNoneOfWhatLooksDifferent) {
  pair.views[0].segments = {seen(0)};
  pair.views[1].image = 1.0 - pair.views[1].image;  // a dark roof over bright ground
  EXPECT_TRUE(found().matches.empty());
}

TEST_F(GuidedMatchesTest, AreNoneWithoutAStep) {
  pair.views[0].segments = {seen(0)};
  pair.views[1].image.setTo(0.5);
  EXPECT_TRUE(found().matches.empty());
}

}  // namespace
}  // namespace ridgeline::reconstruct
