// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/wireframe.h"

#include <gmock/gmock.h>

namespace ridgeline::evaluate {
namespace {

using testing::DoubleNear;
using testing::Eq;
using testing::Optional;

constexpr double kWireframeExact = 1e-12;

/// The four eaves of a house.
std::vector<Segment3> square() {
  const Eigen::Vector3d a(0, 0, 5), b(10, 0, 5), c(10, 8, 5), d(0, 8, 5);
  return {{a, b}, {b, c}, {c, d}, {d, a}};
}

std::vector<Segment3> moved(std::vector<Segment3> lines, const Eigen::Vector3d& by) {
  for (Segment3& s : lines) s = {s.start + by, s.end + by};
  return lines;
}

TEST(Wireframe, OfTheTruthIsPerfect) {
  for (const WireframeScore& w : wireframe_scores(square(), square())) {
    EXPECT_EQ(w.corners.n_found, 4U);
    EXPECT_THAT(w.corners.f1(), Optional(1.0));
    EXPECT_THAT(w.edges.f1(), Optional(1.0));
    EXPECT_THAT(w.mean_corner_offset_m, Optional(DoubleNear(0.0, kWireframeExact)));
  }
}

TEST(Wireframe, FindsCornersUpToTheThreshold) {
  const auto scores = wireframe_scores(moved(square(), {0.2, 0, 0}), square());
  EXPECT_THAT(scores[0].corners.f1(), Optional(0.0));
  EXPECT_THAT(scores[0].mean_corner_offset_m, Eq(std::nullopt));
  EXPECT_THAT(scores[1].corners.f1(), Optional(1.0));
  EXPECT_THAT(scores[1].mean_corner_offset_m, Optional(DoubleNear(0.2, kWireframeExact)));
}

TEST(Wireframe, CountsEachTrueEdgeOnceWhicheverWayItRuns) {
  std::vector<Segment3> lines = square();
  std::swap(lines[0].start, lines[0].end);
  lines.push_back(lines[1]);
  lines.push_back({{0, 0, 5}, {10, 8, 5}});  // a diagonal between true corners
  const WireframeScore w = wireframe_scores(lines, square())[0];
  EXPECT_EQ(w.edges.n_matched, 4U);
  EXPECT_THAT(w.edges.precision(), Optional(DoubleNear(4.0 / 6.0, kWireframeExact)));
  EXPECT_THAT(w.edges.recall(), Optional(1.0));
}

TEST(Wireframe, MatchesTheNearestCornerFirst) {
  const std::vector<Segment3> truth{{{0, 0, 0}, {5, 0, 0}}};
  const std::vector<Segment3> lines{{{0.3, 0, 0}, {9, 9, 9}}, {{0.1, 0, 0}, {5, 0, 0}}};
  const WireframeScore w = wireframe_scores(lines, truth)[2];
  EXPECT_EQ(w.corners.n_matched, 2U);
  EXPECT_EQ(w.edges.n_matched, 1U);
  EXPECT_THAT(w.mean_corner_offset_m, Optional(DoubleNear(0.05, kWireframeExact)));
}

TEST(Wireframe, OfNothingHasNoFigures) {
  const WireframeScore w = wireframe_scores({}, square())[0];
  EXPECT_THAT(w.edges.precision(), Eq(std::nullopt));
  EXPECT_THAT(w.edges.recall(), Optional(0.0));
}

}  // namespace
}  // namespace ridgeline::evaluate
