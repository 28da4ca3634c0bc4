// SPDX-License-Identifier: BSD-3-Clause
// A line along x, 10 m, and planes beside it whose points are given.
#include "evaluate/judge/surface_decision.h"

#include "evaluate/judge/image_evidence.h"
#include "evaluate/judge/plane_meeting.h"
#include "tests/evaluate/judge/nadir_pair.h"

#include <gmock/gmock.h>

#include <functional>
#include <vector>

namespace ridgeline::evaluate {
namespace {

using Heights = std::function<double(double, double)>;

constexpr double kSurfaceLength_m = 10.0;

/// Points of z = height(s, t) on a regular grid of a rectangle beside the line.
CandidatePlane surface(const Heights& height,
                       double t_from,
                       double t_to,
                       double s_from = 0.0,
                       double s_to = kSurfaceLength_m) {
  CandidatePlane plane;
  std::vector<Eigen::Vector3d> x;
  for (double s = s_from; s <= s_to; s += 0.25) {
    for (double t = t_from; t <= t_to + 1e-9; t += 0.25) {
      x.emplace_back(s, t, height(s, t));
      plane.beside.push_back({x.back(), s, t, 0});
    }
  }
  plane.inliers = plane.beside;
  plane.fit = fit_plane(x).value();
  plane.coverage = coverage_along(plane.beside, kSurfaceLength_m, 0.3);
  return plane;
}

double eave(double /*s*/, double t) { return 6.0 + 0.5 * t; }
double meadow(double /*s*/, double /*t*/) { return 0.0; }

std::vector<CandidatePlane> roof_over_ground() {
  return {surface(eave, 0.0, 1.5), surface(meadow, -1.5, -0.25)};
}

JudgedLine line_at(double z) {
  JudgedLine line;
  line.segment = {{0, 0, z}, {kSurfaceLength_m, 0, z}};
  return line;
}

SurfaceDecision decide(const std::vector<CandidatePlane>& planes,
                       const JudgedLine& line,
                       std::vector<ZonePoint> further_points = {},
                       const JudgeOptions& options = {}) {
  std::vector<ZonePoint> zone = std::move(further_points);
  for (const CandidatePlane& plane : planes) {
    zone.insert(zone.end(), plane.inliers.begin(), plane.inliers.end());
  }
  return decide_surface(zone, planes, footprint_of(line.segment), line, options);
}

TEST(DecideSurface, OfALineOnItsEaveIsTheRoof) {
  const SurfaceDecision decision = decide(roof_over_ground(), line_at(6.0));
  ASSERT_EQ(decision.status, Status::kEvaluated) << decision.reason;
  EXPECT_EQ(decision.planes, std::vector<std::size_t>{0});
  EXPECT_EQ(decision.surface, JudgingSurface::kUpper);
}

TEST(DecideSurface, OfALineInOpenGroundIsTheGroundByThePlanWhereverTheLineLies) {
  for (const double z : {0.0, 1.0, 7.0}) {
    const SurfaceDecision decision = decide({surface(meadow, -1.5, 1.5)}, line_at(z));
    ASSERT_EQ(decision.status, Status::kEvaluated) << z << decision.reason;
    EXPECT_EQ(decision.decided_by, DecidedBy::kPlan) << z;
  }
}

TEST(DecideSurface, OfALineFarAboveTheGroundIsNotTheGroundIfPointsLieNextToIt) {
  // two points of a surface that is too small for a plane
  const std::vector<ZonePoint> beside{{{4.0, 0.6, 7.0}, 4.0, 0.6, 0},
                                      {{5.0, 0.7, 7.0}, 5.0, 0.7, 0}};
  const std::vector<CandidatePlane> ground{surface(meadow, -1.5, 1.5)};
  EXPECT_EQ(decide(ground, line_at(7.0)).status, Status::kEvaluated);
  EXPECT_EQ(decide(ground, line_at(7.0), beside).status, Status::kAmbiguous);
}

TEST(DecideSurface, OfALineUnderAnOverhangIsTheGroundByItsPlaceAlone) {
  // the roof goes on for half a metre beyond the line, and hides the ground as far
  const std::vector<CandidatePlane> planes{surface(eave, -0.5, 1.5), surface(meadow, -1.5, -0.75)};
  const SurfaceDecision decision = decide(planes, line_at(0.0));
  ASSERT_EQ(decision.status, Status::kEvaluated) << decision.reason;
  EXPECT_EQ(decision.planes, std::vector<std::size_t>{1});
  EXPECT_EQ(decision.surface, JudgingSurface::kGround);
  EXPECT_EQ(decision.decided_by, DecidedBy::kPlace);
}

TEST(DecideSurface, BelowTheLeastProbabilityIsAmbiguousAndNamesBothSurfaces) {
  JudgeOptions options;
  options.min_probability = 1.0;
  const SurfaceDecision decision = decide(roof_over_ground(), line_at(9.0), {}, options);
  EXPECT_EQ(decision.status, Status::kAmbiguous);
  EXPECT_THAT(decision.reason, testing::HasSubstr("the upper surface"));
  EXPECT_THAT(decision.reason, testing::HasSubstr("the ground"));
  EXPECT_FALSE(decision.decided_by);
}

TEST(DecideSurface, OfTwoPlanesThatMeetIsBoth) {
  const std::vector<CandidatePlane> planes{
      surface([](double, double t) { return 9.0 - 0.5 * t; }, 0.0, 1.5),
      surface([](double, double t) { return 9.0 + 0.5 * t; }, -1.5, 0.0)};
  const SurfaceDecision decision = decide(planes, line_at(9.0));
  ASSERT_EQ(decision.status, Status::kEvaluated) << decision.reason;
  EXPECT_EQ(decision.kind, Kind::kRidge);
  EXPECT_EQ(decision.surface, JudgingSurface::kRidge);
  EXPECT_EQ(decision.planes, (std::vector<std::size_t>{0, 1}));
}

TEST(DecideSurface, IsARidgeBesideTheLineToo) {
  const std::vector<CandidatePlane> planes{
      surface([](double, double t) { return 9.0 - 0.5 * (t - 0.25); }, 0.25, 1.5),
      surface([](double, double t) { return 9.0 + 0.5 * (t - 0.25); }, -1.5, 0.25)};
  EXPECT_EQ(decide(planes, line_at(9.0)).kind, Kind::kRidge);
}

TEST(DecideSurface, OfALineFarFromEverySurfaceIsTheLikeliestByThePlan) {
  // it is wrong whichever surface it is an edge of
  const SurfaceDecision decision = decide(roof_over_ground(), line_at(20.0));
  ASSERT_EQ(decision.status, Status::kEvaluated) << decision.reason;
  EXPECT_TRUE(decision.is_far);
  EXPECT_EQ(decision.planes, std::vector<std::size_t>{0});
  EXPECT_FALSE(decide(roof_over_ground(), line_at(6.1)).is_far);
}

TEST(DecideSurface, HasTwoPlanesOfOneHeightForOneSurface) {
  // they do not meet along the line, and give it the same distance
  const std::vector<CandidatePlane> planes{
      surface([](double, double t) { return 5.0 + 0.02 * t; }, 0.25, 1.5),
      surface([](double, double t) { return 5.05 + 0.02 * t; }, -1.5, -0.25)};
  const SurfaceDecision decision = decide(planes, line_at(5.0));
  EXPECT_EQ(decision.status, Status::kEvaluated) << decision.reason;
  EXPECT_GT(decision.probability.value_or(0.0), 0.95);
}

TEST(DecideSurface, OfABorderIsThePlaneOnItsKnownSide) {
  for (const double y : {1.0, -1.0}) {
    JudgedLine line = line_at(y > 0.0 ? 6.0 : 0.0);
    line.inside = Eigen::Vector2d(0.0, y);
    const SurfaceDecision decision = decide(roof_over_ground(), line);
    ASSERT_EQ(decision.status, Status::kEvaluated) << decision.reason;
    EXPECT_EQ(decision.planes, std::vector<std::size_t>{y > 0.0 ? 0U : 1U});
  }
}

TEST(DecideSurface, OfTheFootOfADormerIsTheRoofThatGoesOnBehindIt) {
  // 0.75 m of the roof between foot and eave, more of it beyond the dormer, and the ground below
  CandidatePlane roof = surface(eave, -0.75, 0.0);
  const CandidatePlane behind = surface(eave, 2.0, 4.0);
  for (std::vector<ZonePoint>* points : {&roof.beside, &roof.inliers})
    points->insert(points->end(), behind.beside.begin(), behind.beside.end());
  JudgedLine line = line_at(6.0);
  line.inside = Eigen::Vector2d(0.0, -1.0);
  const SurfaceDecision decision = decide({roof, surface(meadow, -1.5, -1.0)}, line);
  ASSERT_EQ(decision.status, Status::kEvaluated) << decision.reason;
  EXPECT_EQ(decision.planes, std::vector<std::size_t>{0});
}

TEST(DecideSurface, OfTheEdgeOfACarIsItsRoofAndOfAMarkingBesideItTheGround) {
  const std::vector<CandidatePlane> planes{surface([](double, double) { return 1.4; }, 0.0, 1.5),
                                           surface(meadow, -1.5, -0.25)};
  EXPECT_EQ(decide(planes, line_at(1.4)).planes, std::vector<std::size_t>{0});
  EXPECT_EQ(decide(planes, line_at(0.0)).planes, std::vector<std::size_t>{1});
}

TEST(DecideSurface, OfABorderIsNoRidgeAndNoPlaneOnTheOtherSide) {
  std::vector<CandidatePlane> planes{
      surface([](double, double t) { return 9.0 - 0.5 * t; }, 0.0, 1.5),
      surface([](double, double t) { return 9.0 + 0.5 * t; }, -1.5, 0.0)};
  JudgedLine line = line_at(9.0);
  line.inside = Eigen::Vector2d(0.0, -1.0);
  EXPECT_EQ(decide(planes, line).planes, std::vector<std::size_t>{1});
  planes.pop_back();
  EXPECT_EQ(decide(planes, line).status, Status::kLowCoverage);
}

TEST(DecideSurface, PointsAlongTheLineThatNoPlaneExplainsMakeItAnObjects) {
  const std::vector<CandidatePlane> planes{surface(meadow, -1.5, 1.5)};
  std::vector<ZonePoint> hedge;
  for (double s = 0.1; s < kSurfaceLength_m; s += 0.1) {
    const double z = 1.0 + 0.25 * std::sin(40.0 * s);
    hedge.push_back({{s, 0.1, z}, s, 0.1, 0});
  }
  EXPECT_EQ(decide(planes, line_at(1.0)).status, Status::kEvaluated);
  const SurfaceDecision decision = decide(planes, line_at(1.0), hedge);
  EXPECT_EQ(decision.surface, JudgingSurface::kObject);
  EXPECT_NE(decision.status, Status::kEvaluated);
}

TEST(DecideSurface, SaysThatNoPlaneAccompaniesTheLine) {
  const SurfaceDecision decision = decide({surface(eave, 0.0, 1.5, 0.0, 3.0)}, line_at(6.0));
  EXPECT_EQ(decision.status, Status::kLowCoverage);
  EXPECT_THAT(decision.reason, testing::HasSubstr("33 %"));
  EXPECT_FALSE(decision.surface);
  EXPECT_EQ(decide({}, line_at(6.0)).status, Status::kNoPlane);
}

TEST(DecideSurface, FlagsALineInsideAPlaneAsMerged) {
  const SurfaceDecision decision = decide({surface(meadow, -1.5, 1.5)}, line_at(0.0));
  EXPECT_EQ(decision.flags, std::vector<std::string>{"merged"});
}

/// What three images show of a line at a height: two aside of each other, which tell its height,
/// and one along it.
ImageEvidence seen_by_three(double z) {
  ImageEvidence images = test::seen({{0, 0, z}, {kSurfaceLength_m, 0, z}});
  ProjectionMatrix aside;
  aside << 10000, 0, 0, 0, 0, -10000, 0, 2e6, 0, 0, -1, 800;  // 200 m to the north
  const Segment3 line{{0, 0, z}, {kSurfaceLength_m, 0, z}};
  images.observations.insert(images.observations.begin() + 1, {aside, project(aside, line)});
  return images;
}

TEST(DecideSurface, OfALineThatThreeImagesShowIsWhereTheyShowItWhateverItsPlace) {
  JudgedLine line = line_at(6.0);
  line.images = seen_by_three(0.0);
  const SurfaceDecision decision = decide(roof_over_ground(), line);
  ASSERT_EQ(decision.status, Status::kEvaluated) << decision.reason;
  EXPECT_EQ(decision.planes, std::vector<std::size_t>{1});
  EXPECT_EQ(decision.decided_by, DecidedBy::kImages);
}

TEST(DecideSurface, OfALineThatThreeImagesShowBetweenTheSurfacesIsAnObject) {
  JudgedLine line = line_at(3.0);
  line.images = seen_by_three(3.0);
  const SurfaceDecision decision = decide(roof_over_ground(), line);
  EXPECT_EQ(decision.surface, JudgingSurface::kObject);
  EXPECT_NE(decision.status, Status::kEvaluated);
}

TEST(HasIndependentObservation, NeedsAnImageOffTheBaseOfTheFirstTwo) {
  ImageEvidence images = seen_by_three(0.0);
  EXPECT_TRUE(has_independent_observation(images));
  images.observations.erase(images.observations.begin() + 1);
  EXPECT_FALSE(has_independent_observation(images));
  images.observations.push_back({test::camera_at(300.0), images.base().px});
  EXPECT_FALSE(has_independent_observation(images)) << "in one flight line";
}

TEST(ObservationsChiSquare, IsNoneForTheSurfaceSeenAndLimitedForAnother) {
  constexpr double kRounding = 1e-9;
  constexpr double kSigma_px = 1.0;
  const ImageEvidence images = seen_by_three(2.0);
  const auto level = [](double z) { return Plane3(Eigen::Vector3d::UnitZ(), -z); };
  EXPECT_NEAR(observations_chi_square(images, level(2.0), kSigma_px), 0.0, kRounding);
  EXPECT_NEAR(observations_chi_square(images, kSigma_px), 0.0, kRounding);
  // the third image lies along the line, which does not tell the heights apart
  EXPECT_NEAR(observations_chi_square(images, level(8.0), kSigma_px), 25.0, kRounding);
}

TEST(MeetingOf, HasNoAnswerForParallelPlanesOrPlanesOnOneSide) {
  const Footprint footprint = footprint_of(line_at(0.0).segment);
  const auto upper = surface([](double, double t) { return 9.0 - 0.5 * t; }, 0.0, 1.5);
  const auto lower = surface([](double, double t) { return 4.0 - 0.5 * t; }, -1.5, 0.0);
  EXPECT_FALSE(meeting_of(upper, lower, footprint, {}));
  const auto crossing = surface([](double, double t) { return 9.0 + 0.5 * t; }, 0.0, 1.5);
  EXPECT_FALSE(meeting_of(upper, crossing, footprint, {}));
}

}  // namespace
}  // namespace ridgeline::evaluate
