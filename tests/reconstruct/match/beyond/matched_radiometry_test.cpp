// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/matched_radiometry.h"

#include "reconstruct/appearance/edge_appearance.h"
#include "tests/reconstruct/match/ok2011/painted_pair.h"

#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

using test::PaintedPair;

constexpr double kGain = 0.8;
constexpr double kOffset = 0.05;
/// Flanks are means over a few pixels, sampled at other places in the two images.
constexpr float kSampling = 0.01F;

/// Six roofs and lines on the ground between them; the right image has less contrast.
PaintedPair village() {
  std::vector<PaintedPair::Roof> roofs;
  for (const double west : {-11.0, -2.0, 7.0}) {
    for (const double south : {-9.0, 3.0}) {
      roofs.push_back({west, south, west + 5.0, south + 6.0, 4.0});
    }
  }
  PaintedPair pair(roofs);
  pair.views[1].image = kGain * pair.views[1].image + kOffset;
  for (const PaintedPair::Roof& roof : roofs) {
    pair.add_outline(roof);
    pair.add_line({{roof.west - 1.5, roof.south, 0.0}, {roof.west - 1.5, roof.north, 0.0}});
  }
  return pair;
}

/// Adds walls that only the right image shows: lines in its corner with darker sides than all
/// others.
void add_walls(View& right, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    EdgeSegment wall = test::edge({{2.0, 2.0}, {2.0, 12.0}});
    wall.left.colour[0] = 0.05F;
    wall.right.colour[0] = 0.1F;
    right.segments.push_back(wall);
  }
}

Radiometry matched_radiometry(const PaintedPair& pair, const Radiometry& first) {
  return matched_radiometry(pair.searched(), first, {});
}

struct Found {
  Radiometry first, matched;
};
Found radiometry_of(const PaintedPair& pair) {
  const Radiometry first = relative_radiometry(pair.views[0].segments, pair.views[1].segments);
  return {first, matched_radiometry(pair, first)};
}

TEST(MatchedRadiometry, IsThatOfTheCommonSurfacesWhereOneImageShowsWalls) {
  PaintedPair pair = village();
  add_walls(pair.views[1], pair.views[1].segments.size());
  const Found found = radiometry_of(pair);
  for (const double bright : {0.3, 0.65}) {  // ground, roof
    const auto in_right = static_cast<float>(kGain * bright + kOffset);
    EXPECT_NEAR(found.matched.left_from_right({in_right})[0], bright, kSampling);
    EXPECT_GT(std::abs(found.first.left_from_right({in_right})[0] - bright), 3.0F * kSampling);
  }
}

TEST(MatchedRadiometry, StaysAsItWasWithoutCommonSurfaces) {
  PaintedPair pair = village();
  pair.views[1].segments.resize(3);
  const Found found = radiometry_of(pair);
  EXPECT_EQ(found.matched.gain, found.first.gain);
  EXPECT_EQ(found.matched.offset, found.first.offset);
}

TEST(MatchedRadiometry, DoesNotTakeAWallForTheGroundThatTheOtherImageShows) {
  // beside the east edge of each roof the left image shows the ground and the right one a wall, 14
  // px wide, which is one of the widths that appearance_past_wall() tries; without it there are too
  // few surfaces
  constexpr double kEaves_m = 4.284;
  std::vector<PaintedPair::Roof> roofs;
  for (const double west : {-13.0, -5.0}) {
    for (const double south : {-13.0, -8.5, -4.0, 0.5, 5.0, 9.5}) {
      roofs.push_back({west, south, west + 4.0, south + 3.5, kEaves_m});
    }
  }
  PaintedPair pair(roofs);
  for (const PaintedPair::Roof& r : roofs) {
    pair.add_line({{r.east, r.south, kEaves_m}, {r.east, r.north, kEaves_m}});
  }
  for (const double x : {3.0, 6.0, 9.0}) pair.add_line({{x, -5.0, 0.0}, {x, 5.0, 0.0}});
  const Radiometry same;
  const Radiometry matched = matched_radiometry(pair, same);
  EXPECT_EQ(matched.gain, same.gain);
  EXPECT_EQ(matched.offset, same.offset);
}

TEST(MatchedRadiometry, KeepsTheGainOfABandWithoutContrast) {
  PaintedPair pair = village();
  for (View& view : pair.views) {
    for (EdgeSegment& segment : view.segments) {
      segment.left.colour[0] = 0.4F;
      segment.right.colour[0] = 0.41F;
    }
  }
  const Found found = radiometry_of(pair);
  EXPECT_EQ(found.matched.gain, found.first.gain);
}

}  // namespace
}  // namespace ridgeline::reconstruct
