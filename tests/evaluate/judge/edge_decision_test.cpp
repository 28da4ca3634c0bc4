// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/edge_decision.h"

#include "evaluate/judge/image_evidence.h"
#include "reconstruct/geometry/epipolar.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace ridgeline::evaluate {
namespace {

/// Points of z = height(s, t) on a regular grid of a rectangle beside the line y = 0, x in [0, 10].
CandidatePlane candidate(const std::function<double(double, double)>& height,
                         double t_from,
                         double t_to,
                         double s_from = 0.0,
                         double s_to = 10.0) {
  CandidatePlane plane;
  std::vector<Eigen::Vector3d> positions;
  for (double s = s_from; s <= s_to; s += 0.25) {
    for (double t = t_from; t <= t_to + 1e-9; t += 0.25) {
      const Eigen::Vector3d x(s, t, height(s, t));
      plane.beside.push_back({x, s, t, static_cast<std::uint32_t>(positions.size())});
      positions.push_back(x);
    }
  }
  plane.inliers = plane.beside;
  plane.fit = fit_plane(positions).value();
  plane.coverage = coverage_along(plane.beside, 10.0, 0.3);
  plane.nearest_m = HUGE_VAL;
  for (const ZonePoint& p : plane.beside)
    plane.nearest_m = std::min(plane.nearest_m, std::abs(p.t));
  return plane;
}

const Footprint kLine = footprint_of({{0, 0, 0}, {10, 0, 0}});
double left_slope(double /*s*/, double t) { return 9.0 - 0.5 * t; }
double right_slope(double /*s*/, double t) { return 9.0 + 0.5 * t; }
double ground(double /*s*/, double /*t*/) { return 0.0; }

TEST(DecideEdge, IsARidgeWhereTwoSlopesMeetAlongTheLine) {
  const std::vector<CandidatePlane> planes{candidate(left_slope, 0, 1.5),
                                           candidate(right_slope, -1.5, 0)};
  const EdgeDecision decision = decide_edge(planes, kLine, {});
  EXPECT_EQ(decision.status, Status::kEvaluated);
  EXPECT_EQ(decision.kind, Kind::kRidge);
  EXPECT_EQ(decision.planes, (std::vector<std::size_t>{0, 1}));
}

TEST(DecideEdge, IsARidgeForAValleyToo) {
  const std::vector<CandidatePlane> planes{
      candidate([](double, double t) { return 5.0 + 0.6 * t; }, 0, 1.5),
      candidate([](double, double t) { return 5.0 - 0.6 * t; }, -1.5, 0)};
  EXPECT_EQ(decide_edge(planes, kLine, {}).kind, Kind::kRidge);
}

TEST(DecideEdge, KeepsTheRidgeForALineBesideIt) {
  const Footprint moved = footprint_of({{0, 0.6, 0}, {10, 0.5, 0}});
  const std::vector<CandidatePlane> planes{candidate(left_slope, 0, 1.5),
                                           candidate(right_slope, -1.5, 0)};
  EXPECT_EQ(decide_edge(planes, moved, {}).kind, Kind::kRidge);
}

TEST(DecideEdge, IsAStepForALineFarFromTheRidge) {
  JudgeOptions options;
  options.ridge_offset_m = 0.3;
  const Footprint moved = footprint_of({{0, 0.6, 0}, {10, 0.6, 0}});
  const std::vector<CandidatePlane> planes{candidate(left_slope, 0, 1.5),
                                           candidate(right_slope, -1.5, 0)};
  EXPECT_EQ(decide_edge(planes, moved, options).kind, Kind::kStep);
}

TEST(DecideEdge, TakesTheUpperPlaneAtAStep) {
  const std::vector<CandidatePlane> planes{candidate(ground, -1.5, 0),
                                           candidate(left_slope, 0, 1.5)};
  const EdgeDecision decision = decide_edge(planes, kLine, {});
  EXPECT_EQ(decision.kind, Kind::kStep);
  EXPECT_EQ(decision.planes, (std::vector<std::size_t>{1}));
  EXPECT_THAT(decision.flags.empty() ? "" : decision.flags.front(), std::string("upper_plane"));
}

TEST(DecideEdge, TakesThePlaneOnTheKnownSideOfABorder) {
  const std::vector<CandidatePlane> planes{candidate(ground, -1.5, 0.25),
                                           candidate(left_slope, 0, 1.5)};
  const auto plane_inside = [&](double y) {
    return decide_edge(planes, kLine, {}, std::nullopt, Eigen::Vector2d(0.0, y)).planes;
  };
  EXPECT_EQ(plane_inside(1.0), (std::vector<std::size_t>{1}));
  EXPECT_EQ(plane_inside(-1.0), (std::vector<std::size_t>{0}));
}

TEST(DecideEdge, IsNoRidgeForTheBorderOfOneSurface) {
  const std::vector<CandidatePlane> planes{candidate(left_slope, 0, 1.5),
                                           candidate(right_slope, -1.5, 0)};
  const EdgeDecision decision =
      decide_edge(planes, kLine, {}, std::nullopt, Eigen::Vector2d(0.0, -1.0));
  EXPECT_EQ(decision.kind, Kind::kStep);
  EXPECT_EQ(decision.planes, (std::vector<std::size_t>{1}));
}

TEST(DecideEdge, FindsNoPlaneIfNoneLiesOnTheKnownSide) {
  const std::vector<CandidatePlane> planes{candidate(left_slope, 0, 1.5)};
  EXPECT_EQ(decide_edge(planes, kLine, {}, std::nullopt, Eigen::Vector2d(0.0, -1.0)).status,
            Status::kLowCoverage);
}

TEST(DecideEdge, FlagsALineInsideAPlaneAsMerged) {
  const EdgeDecision decision =
      decide_edge(std::vector<CandidatePlane>{candidate(ground, -1.5, 1.5)}, kLine, {});
  EXPECT_EQ(decision.kind, Kind::kStep);
  EXPECT_EQ(decision.flags, (std::vector<std::string>{"merged"}));
}

TEST(DecideEdge, IgnoresAPlaneTooFarFromTheLine) {
  const std::vector<CandidatePlane> planes{candidate(ground, -1.5, 1.0),
                                           candidate(left_slope, 1.25, 1.5)};
  EXPECT_EQ(decide_edge(planes, kLine, {}).planes, (std::vector<std::size_t>{0}));
}

TEST(DecideEdge, RefusesAPlaneBesideASmallPartOfTheLine) {
  const EdgeDecision decision =
      decide_edge(std::vector<CandidatePlane>{candidate(left_slope, 0, 1.5, 0.0, 3.0)}, kLine, {});
  EXPECT_EQ(decision.status, Status::kLowCoverage);
  EXPECT_THAT(decision.reason, ::testing::HasSubstr("33 %"));
}

TEST(DecideEdge, CallsTwoPlanesOfOneHeightThatDoNotMeetAlongTheLineAmbiguous) {
  // both cover the whole line at the height 9 m at its middle; they intersect across the line
  const std::vector<CandidatePlane> planes{
      candidate([](double s, double) { return 9.0 + 0.5 * (s - 5.0); }, 0.25, 1.5),
      candidate([](double s, double) { return 9.0 - 0.5 * (s - 5.0); }, -1.5, -0.25)};
  EXPECT_EQ(decide_edge(planes, kLine, {}).status, Status::kAmbiguous);
}

/// What two images show of a segment, from 800 m with B/H 0.26 and GSD 8 cm.
ImageEvidence evidence_of(const Segment3& segment) {
  ImageEvidence images;
  for (const double x : {1e6, -1.08e6}) {
    ProjectionMatrix p;
    p << 10000, 0, 0, x, 0, -10000, 0, 0, 0, 0, -1, 800;
    images.sightings.push_back({p, project(p, segment)});
  }
  images.height_range_m = {-10.0, 30.0};
  return images;
}

TEST(DecideEdge, CallsALineOverTheEavesOfTwoRoofsAmbiguousUnlessTheImagesShowTheGround) {
  const auto lower = [](double, double t) { return 6.0 - 0.5 * t; };
  const auto decide = [&](double first_roof_to, double second_roof_from, double seen_at_m) {
    const std::vector<CandidatePlane> planes{candidate(ground, -1.5, 0),
                                             candidate(left_slope, 0, 1.5, 0.0, first_roof_to),
                                             candidate(lower, 0, 1.5, second_roof_from, 10.0)};
    return decide_edge(planes, kLine, {}, evidence_of({{0, 0, seen_at_m}, {10, 0, seen_at_m}}));
  };
  EXPECT_EQ(decide(5.0, 5.25, 9.0).status, Status::kAmbiguous);
  EXPECT_EQ(decide(5.0, 5.25, 0.0).planes, (std::vector<std::size_t>{0}));
  // no plane was found for one of the roofs
  EXPECT_EQ(decide(5.2, 9.75, 9.0).status, Status::kAmbiguous);
  // a shed beside a part of a line on the ground does not make it an edge of the shed
  EXPECT_EQ(decide(3.0, 9.75, 9.0).planes, (std::vector<std::size_t>{0}));
}

TEST(DecideEdge, TakesAPlaneThatEndsFartherAwayOnlyIfTheImagesShowTheLineOnIt) {
  // an overhang of a metre has no points
  const std::vector<CandidatePlane> planes{candidate(ground, -1.5, 0),
                                           candidate(left_slope, 1.0, 1.5)};
  const auto decide = [&](double seen_at_m) {
    return decide_edge(planes, kLine, {}, evidence_of({{0, 0, seen_at_m}, {10, 0, seen_at_m}}));
  };
  const EdgeDecision eave = decide(9.0);
  EXPECT_EQ(eave.planes, (std::vector<std::size_t>{1}));
  EXPECT_THAT(eave.flags, testing::ElementsAre("seen_instead"));
  EXPECT_EQ(decide(0.0).planes, (std::vector<std::size_t>{0}));
  EXPECT_EQ(decide_edge(planes, kLine, {}).planes, (std::vector<std::size_t>{0}));
  // a car that ends as far away does not judge
  std::vector<CandidatePlane> with_car = planes;
  with_car[1].low_object = true;
  EXPECT_EQ(decide_edge(with_car, kLine, {}, evidence_of({{0, 0, 9.0}, {10, 0, 9.0}})).planes,
            (std::vector<std::size_t>{0}));
}

TEST(DecideEdge, TakesASurfaceThatAccompaniesHalfOfTheLineIfTheImagesShowTheLineOnIt) {
  // the laser sees six metres of a street beside a house
  const std::vector<CandidatePlane> planes{candidate(left_slope, 0, 1.5),
                                           candidate(ground, -1.5, 0, 0.0, 6.0)};
  const auto decide = [&](double seen_at_m) {
    return decide_edge(planes, kLine, {}, evidence_of({{0, 0, seen_at_m}, {10, 0, seen_at_m}}))
        .planes;
  };
  EXPECT_EQ(decide(0.0), (std::vector<std::size_t>{1}));
  EXPECT_EQ(decide(9.0), (std::vector<std::size_t>{0}));
}

TEST(DecideEdge, JudgesAMarkingBesideParkedCarsByTheGround) {
  const auto car = [](double, double) { return 1.5; };
  const std::vector<CandidatePlane> planes{candidate(ground, -1.5, 0),
                                           candidate(car, 0, 1.5, 0.0, 4.5),
                                           candidate(car, 0, 1.5, 5.5, 10.0)};
  const ImageEvidence marking = evidence_of({{0, 0, 0.3}, {10, 0, 0.3}});
  EXPECT_EQ(decide_edge(planes, kLine, {}, marking).planes, (std::vector<std::size_t>{0}));
}

TEST(DecideEdge, SaysThatThereIsNoPlane) {
  const EdgeDecision decision = decide_edge({}, kLine, {});
  EXPECT_EQ(decision.status, Status::kNoPlane);
  EXPECT_FALSE(decision.reason.empty());
}

}  // namespace
}  // namespace ridgeline::evaluate
