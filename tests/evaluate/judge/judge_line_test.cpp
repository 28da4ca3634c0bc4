// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/judge_line.h"

#include "evaluate/judge/judge_lines.h"
#include "tests/support/sampled_roof.h"

#include <gmock/gmock.h>

#include <limits>
#include <string>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kNoiseFree = 1e-9;
// 5 points/m2 and 3.4 cm: the plane's standard deviation at an eave of this roof is below 1 cm
constexpr double kNoisy = 0.03;

PointGrid grid_of(const std::vector<Eigen::Vector3d>& points) {
  return PointGrid::build(points.size(), [&](std::size_t i) { return points[i]; });
}

JudgedLine line(const Segment3& segment, std::string id = "1") {
  JudgedLine judged;
  judged.id = std::move(id);
  judged.segment = segment;
  return judged;
}

Segment3 moved(const Segment3& s, const Eigen::Vector3d& by) { return {s.start + by, s.end + by}; }

struct House {
  test::SampledRoof roof;
  [[nodiscard]] Segment3 ridge() const {
    return {{0, 0, roof.ridge_height_m()}, {roof.length_m, 0, roof.ridge_height_m()}};
  }
  [[nodiscard]] Segment3 eave() const {
    return {{0, roof.half_width_m, roof.eave_height_m},
            {roof.length_m, roof.half_width_m, roof.eave_height_m}};
  }
};

TEST(JudgeLine, IsExactForNoiseFreePoints) {
  const House house;
  const PointGrid grid = grid_of(house.roof.sample(20.0, 0.0, 1));
  const double nz = house.roof.normal_z();

  const LineEvaluation ridge = judge_line(grid, line(house.ridge()), {}).evaluation;
  ASSERT_EQ(ridge.status, Status::kEvaluated) << ridge.reason;
  EXPECT_EQ(ridge.kind, Kind::kRidge);
  EXPECT_NEAR(*ridge.mean_distance_m, 0.0, kNoiseFree);
  EXPECT_NEAR(*ridge.intersection_distance_m, 0.0, kNoiseFree);

  const LineEvaluation eave =
      judge_line(grid, line(moved(house.eave(), {0, 0, 0.25})), {}).evaluation;
  ASSERT_EQ(eave.status, Status::kEvaluated) << eave.reason;
  EXPECT_EQ(eave.kind, Kind::kStep);
  EXPECT_NEAR(*eave.mean_distance_m, 0.25 * nz, kNoiseFree);
  EXPECT_NEAR(*eave.signed_mean_m, 0.25 * nz, kNoiseFree);
}

TEST(JudgeLine, JudgesALineMetresOffByTheSamePlanes) {
  const House house;
  const PointGrid grid = grid_of(house.roof.sample(5.0, 0.034, 2));
  for (const double lift : {6.0, -3.0}) {
    const LineEvaluation e =
        judge_line(grid, line(moved(house.eave(), {0, 0, lift})), {}).evaluation;
    ASSERT_EQ(e.status, Status::kEvaluated) << e.reason;
    EXPECT_NEAR(*e.signed_mean_m, lift * house.roof.normal_z(), kNoisy);
  }
}

TEST(JudgeLine, TakesALineUnderAnEaveForAnEdgeOfTheGroundByItsPlace) {
  const House house;
  const PointGrid grid = grid_of(house.roof.sample(5.0, 0.034, 3));
  const LineEvaluation e =
      judge_line(grid, line(moved(house.eave(), {0, 0, -house.roof.eave_height_m})), {}).evaluation;
  ASSERT_EQ(e.status, Status::kEvaluated) << e.reason;
  EXPECT_EQ(e.surface, JudgingSurface::kGround);
  EXPECT_EQ(e.decided_by, DecidedBy::kPlace);
  EXPECT_LT(*e.mean_distance_m, kNoisy);
}

TEST(JudgeLine, TellsBothPlanesAndTheIntersectionOfARidge) {
  const House house;
  const PointGrid grid = grid_of(house.roof.sample(8.0, 0.034, 4));
  const LineEvaluation e = judge_line(grid, line(moved(house.ridge(), {0, 0.4, 0})), {}).evaluation;
  ASSERT_EQ(e.kind, Kind::kRidge);
  // a shift of 0.4 m aside lifts the line above one plane and sinks it below the other
  EXPECT_NEAR(*e.mean_distance_m, 0.4 * house.roof.slope * house.roof.normal_z(), kNoisy);
  EXPECT_NEAR(*e.intersection_distance_m, 0.4, kNoisy);
  EXPECT_NEAR(*e.intersection_angle_deg, 0.0, 0.5);
}

TEST(JudgeLine, EndsInAStatusForEveryBadLine) {
  const House house;
  const PointGrid grid = grid_of(house.roof.sample(5.0, 0.034, 5));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto status = [&](const Segment3& s) {
    const LineEvaluation e = judge_line(grid, line(s), {}).evaluation;
    for (const auto& figure :
         {e.mean_distance_m, e.max_distance_m, e.signed_mean_m, e.sigma_plane_m})
      EXPECT_EQ(figure.has_value(), e.status == Status::kEvaluated) << name(e.status);
    return e.status;
  };
  EXPECT_EQ(status({{nan, 0, 0}, {1, 0, 0}}), Status::kNonFinite);
  for (const double far : {1.0001e7, 1e30, -1e308}) {
    EXPECT_EQ(status({{far, 0, 0}, {1, 0, 0}}), Status::kOutOfRange) << far;
    EXPECT_EQ(status({{0, 0, 0}, {1, far, 0}}), Status::kOutOfRange) << far;
    EXPECT_EQ(status({{0, 0, 0}, {1, 0, far}}), Status::kOutOfRange) << far;
  }
  for (const double lift : {-9999.0, -250.0, 120.0}) {
    const LineEvaluation e =
        judge_line(grid, line(moved(house.eave(), {0, 0, lift})), {}).evaluation;
    EXPECT_EQ(e.status, Status::kOutOfRange) << lift;
    EXPECT_THAT(e.reason,
                testing::HasSubstr(lift < 0.0 ? "m below all points" : "m above all points"));
  }
  EXPECT_EQ(status(moved(house.eave(), {0, 0, 60.0})), Status::kEvaluated) << "another system";
  EXPECT_EQ(status({{0, 0, 310.0}, {11, 1, 310.5}}), Status::kEvaluated) << "an error of a tool";
  EXPECT_EQ(status({{1, 1, 1}, {1, 1, 1}}), Status::kDegenerate);
  EXPECT_EQ(status({{1, 1, 1}, {1, 1, 4}}), Status::kDegenerate);
  EXPECT_EQ(status({{1, 1, 1}, {1.1, 1, 1}}), Status::kTooShort);
  EXPECT_EQ(status({{900, 0, 0}, {910, 0, 0}}), Status::kNoLidar);
  JudgedLine lost = line(house.ridge());
  lost.reconstructed = false;
  EXPECT_EQ(judge_line(grid, lost, {}).evaluation.status, Status::kNotReconstructed);
}

/// Lines on and beside all edges of the roof, in several directions.
std::vector<Segment3> lines_about(const House& house) {
  std::vector<Segment3> lines;
  const Segment3 verge{house.eave().start, house.ridge().start};
  for (const Segment3& edge : {house.ridge(), house.eave(), verge}) {
    for (const double aside_m : {-0.3, 0.0, 0.2}) {
      lines.push_back(moved(edge, {aside_m, aside_m, 0.5 * aside_m}));
    }
  }
  return lines;
}

void expect_same_judgement(const LineEvaluation& a, const LineEvaluation& b, double tolerance_m) {
  ASSERT_EQ(a.status, b.status) << a.reason << " / " << b.reason;
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.flags, b.flags);
  EXPECT_NEAR(*a.mean_distance_m, *b.mean_distance_m, tolerance_m);
  EXPECT_NEAR(*a.signed_mean_m, *b.signed_mean_m, tolerance_m);
  EXPECT_NEAR(*a.max_distance_m, *b.max_distance_m, tolerance_m);
}

TEST(JudgeLine, GivesTheSameForALineTheOtherWayRound) {
  constexpr double kRounding_m = 1e-9;
  const House house;
  for (const std::uint64_t seed : {11, 12, 13, 14}) {
    const PointGrid grid = grid_of(house.roof.sample(5.0, 0.034, seed));
    for (const Segment3& s : lines_about(house)) {
      const LineEvaluation there = judge_line(grid, line(s), {}).evaluation;
      const LineEvaluation back = judge_line(grid, line({s.end, s.start}), {}).evaluation;
      expect_same_judgement(there, back, kRounding_m);
    }
  }
}

TEST(JudgeLine, TakesPointsAtTheSamePlaceAsOne) {
  constexpr double kRounding_m = 1e-9;
  const House house;
  const std::vector<Eigen::Vector3d> points = house.roof.sample(5.0, 0.034, 15);
  std::vector<Eigen::Vector3d> tripled;
  for (int copy = 0; copy < 3; ++copy) tripled.insert(tripled.end(), points.begin(), points.end());
  for (const Segment3& s : lines_about(house)) {
    expect_same_judgement(judge_line(grid_of(points), line(s), {}).evaluation,
                          judge_line(grid_of(tripled), line(s), {}).evaluation, kRounding_m);
  }
}

TEST(JudgeLine, SurvivesAnEmptyCloud) {
  EXPECT_EQ(judge_line(grid_of({}), line({{0, 0, 0}, {5, 0, 0}}), {}).evaluation.status,
            Status::kNoLidar);
}

TEST(JudgeLine, PropagatesTheLinesCovarianceToItsNormalDirection) {
  const House house;
  const PointGrid grid = grid_of(house.roof.sample(5.0, 0.034, 6));
  JudgedLine judged = line(house.eave());
  judged.covariance_m2 = Eigen::Matrix<double, 6, 6>::Identity() * 0.04;  // 0.2 m each, independent
  const LineEvaluation e = judge_line(grid, judged, {}).evaluation;
  ASSERT_TRUE(e.sigma_line_m && e.z);
  EXPECT_NEAR(*e.sigma_line_m, 0.2 / std::sqrt(2.0), 1e-12);  // the mean of two ends
  EXPECT_NEAR(*e.z, *e.signed_mean_m / std::hypot(*e.sigma_line_m, *e.sigma_plane_m), 1e-12);
}

TEST(JudgeLine, DoesNotDependOnWhereTheSceneLies) {
  const House house;
  const Eigen::Vector3d shift(513000, 5403000, 250);
  std::vector<Eigen::Vector3d> points = house.roof.sample(5.0, 0.034, 7);
  const LineEvaluation here =
      judge_line(grid_of(points), line(moved(house.eave(), {0.2, 0.1, 0.3})), {}).evaluation;
  for (Eigen::Vector3d& p : points) p += shift;
  const LineEvaluation there =
      judge_line(grid_of(points), line(moved(house.eave(), Eigen::Vector3d(0.2, 0.1, 0.3) + shift)),
                 {})
          .evaluation;
  ASSERT_EQ(here.status, Status::kEvaluated);
  ASSERT_EQ(there.status, Status::kEvaluated);
  EXPECT_NEAR(*here.mean_distance_m, *there.mean_distance_m, 1e-6);
}

TEST(JudgeLines, MarksALaterLineWithTheSameId) {
  const House house;
  const PointGrid grid = grid_of(house.roof.sample(5.0, 0.034, 8));
  const std::vector<JudgedLine> lines{line(house.ridge(), "a"), line(house.eave(), "a")};
  const auto results = judge_lines(grid, lines, {});
  EXPECT_EQ(results[0].evaluation.status, Status::kEvaluated);
  EXPECT_EQ(results[1].evaluation.status, Status::kDuplicateId);
}

TEST(JudgeLines, GivesLinesOfOnePlaneTheSamePlaneId) {
  const House house;
  const PointGrid grid = grid_of(house.roof.sample(5.0, 0.034, 9));
  const Segment3 other_eave = moved(house.eave(), {0, -2.0 * house.roof.half_width_m, 0});
  const std::vector<JudgedLine> lines{line(house.ridge(), "ridge"), line(house.eave(), "eave"),
                                      line(other_eave, "other")};
  const auto results = judge_lines(grid, lines, {});
  const auto& ridge = results[0].evaluation.planes;
  ASSERT_EQ(ridge.size(), 2U);
  const std::uint64_t eave = results[1].evaluation.planes.at(0).id;
  const std::uint64_t other = results[2].evaluation.planes.at(0).id;
  EXPECT_NE(eave, other);
  EXPECT_THAT((std::vector<std::uint64_t>{ridge[0].id, ridge[1].id}),
              ::testing::UnorderedElementsAre(eave, other));
}

TEST(JudgeLines, RejectsAnOptionOutOfRange) {
  JudgeOptions options;
  options.min_coverage = 1.5;
  EXPECT_THROW(judge_lines(grid_of({}), {}, options), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::evaluate
