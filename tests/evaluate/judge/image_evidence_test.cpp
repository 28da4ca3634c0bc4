// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/image_evidence.h"

#include "evaluate/judge/judge_line.h"
#include "tests/evaluate/judge/nadir_pair.h"
#include "tests/support/random.h"
#include "tests/support/sampled_roof.h"

#include <gmock/gmock.h>

#include <vector>

namespace ridgeline::evaluate {
namespace {

using test::seen;

constexpr double kLidarSigma_m = 0.034;
constexpr double kEvidenceDensity_per_m2 = 8.0;
// a hit lies within the search radius (0.3 m) of the ray, so it is at most this high on a roof of
// slope 0.5
constexpr double kHit_m = 0.2;

class OnRoof : public testing::Test {
 protected:
  OnRoof() {
    const auto points = roof_.sample(kEvidenceDensity_per_m2, kLidarSigma_m, 5);
    grid_ = PointGrid::build(points.size(), [&](std::size_t i) { return points[i]; });
  }

  [[nodiscard]] Segment3 ridge() const {
    return {{1, 0, roof_.ridge_height_m()}, {11, 0, roof_.ridge_height_m()}};
  }
  [[nodiscard]] Segment3 verge() const {
    return {{roof_.length_m, 0.3, roof_.ridge_height_m() - 0.15},
            {roof_.length_m, 4.5, roof_.ridge_height_m() - 2.25}};
  }

  test::SampledRoof roof_;
  PointGrid grid_;
};

TEST_F(OnRoof, MonoplotFindsTheSurfaceThatTheBaseImageShows) {
  for (const Segment3& truth : {ridge(), verge()}) {
    const auto found = monoplot(grid_, seen(truth));
    ASSERT_TRUE(found);
    EXPECT_LT((found->start - truth.start).norm(), kHit_m);
    EXPECT_LT((found->end - truth.end).norm(), kHit_m);
  }
}

TEST_F(OnRoof, MonoplotHasNoAnswerWhereThereIsNoLidar) {
  EXPECT_FALSE(monoplot(grid_, seen({{100, 0, 5}, {110, 0, 5}})));
  EXPECT_FALSE(
      monoplot(PointGrid::build(0, [](std::size_t) { return Eigen::Vector3d(); }), seen(ridge())));
}

TEST_F(OnRoof, LineFarOffAlongTheRayIsJudgedByThePlanesThatItsImageShows) {
  // the base ray moves the line by an eighth of its height error in plan: 2.5 m here
  constexpr double kLift_m = 20.0;
  JudgedLine line;
  line.id = "lifted";
  line.images = seen(ridge());
  const Plane3 high(Eigen::Vector3d::UnitZ(), -(roof_.ridge_height_m() + kLift_m));
  const auto& [base, base_px] = line.images->base();
  line.segment = {point_on_plane(base, base_px.start, high),
                  point_on_plane(base, base_px.end, high)};
  const LineEvaluation judged = judge_line(grid_, line, {}).evaluation;
  ASSERT_EQ(judged.status, Status::kEvaluated) << judged.reason;
  EXPECT_EQ(judged.kind, Kind::kRidge);
  EXPECT_NEAR(*judged.mean_distance_m, kLift_m * roof_.normal_z(), 0.05);
}

TEST_F(OnRoof, ALineOnTheGroundInFrontOfAnEaveIsJudgedByTheGround) {
  const double y = roof_.half_width_m + 0.3;
  JudgedLine line;
  line.id = "kerb";
  line.segment = {{2, y, 0}, {10, y, 0}};
  for (const bool with_images : {false, true}) {
    if (with_images) line.images = seen(line.segment);
    const LineEvaluation judged = judge_line(grid_, line, {}).evaluation;
    ASSERT_EQ(judged.status, Status::kEvaluated) << judged.reason;
    EXPECT_LT(*judged.mean_distance_m, 0.03);
  }
}

/// Level ground with a row of trees along x = 0, across the base, from 2.5 to 8 m up.
PointGrid trees() {
  test::Random random(3);
  std::vector<Eigen::Vector3d> points;
  for (double y = -5.0; y < 15.0; y += 0.35) {
    for (double x = -6.0; x < 6.0; x += 0.35)
      points.emplace_back(x, y, random.normal(kLidarSigma_m));
  }
  for (int i = 0; i < 200; ++i) {
    points.emplace_back(random.uniform(-0.8, 0.8), random.uniform(-1.0, 11.0),
                        random.uniform(2.5, 8.0));
  }
  return PointGrid::build(points.size(), [&](std::size_t i) { return points[i]; });
}

TEST(JudgeAmongTrees, TheirOutlineIsNotJudgedByTheGround) {
  JudgedLine line;
  line.id = "outline";
  line.segment = {{0.2, 1, 5.0}, {0.2, 9, 5.0}};
  EXPECT_EQ(judge_line(trees(), line, {}).evaluation.status, Status::kAmbiguous);
  line.images = seen(line.segment);
  EXPECT_EQ(judge_line(trees(), line, {}).evaluation.status, Status::kAmbiguous);
}

TEST(JudgeAmongTrees, ALineOfTheGroundBelowIsJudged) {
  JudgedLine line;
  line.id = "kerb";
  line.segment = {{0.2, 1, 0.0}, {0.2, 9, 0.0}};
  line.images = seen(line.segment);
  const LineEvaluation judged = judge_line(trees(), line, {}).evaluation;
  ASSERT_EQ(judged.status, Status::kEvaluated) << judged.reason;
  EXPECT_LT(*judged.mean_distance_m, 0.03);
}

/// A car of 1.8 m x 4.2 m, 1.4 m high, on level ground; its western side is x = 0, across the base.
PointGrid car() {
  test::Random random(5);
  std::vector<Eigen::Vector3d> points;
  for (double y = -5.0; y < 10.0; y += 0.35) {
    for (double x = -6.0; x < 6.0; x += 0.35) {
      const bool on_car = x > 0.0 && x < 1.8 && y > 0.0 && y < 4.2;
      points.emplace_back(x, y, (on_car ? 1.4 : 0.0) + random.normal(kLidarSigma_m));
    }
  }
  return PointGrid::build(points.size(), [&](std::size_t i) { return points[i]; });
}

double distance_of(const Segment3& segment) {
  JudgedLine line;
  line.id = "beside a car";
  line.segment = segment;
  line.images = seen(segment);
  const LineEvaluation judged = judge_line(car(), line, {}).evaluation;
  EXPECT_EQ(judged.status, Status::kEvaluated) << judged.reason;
  return *judged.mean_distance_m;
}

TEST(JudgeBesideACar, TheEdgeOfItsRoofIsJudgedByIt) {
  EXPECT_LT(distance_of({{0, 0.2, 1.4}, {0, 4.0, 1.4}}), 0.03);
}

TEST(JudgeBesideACar, AMarkingIsJudgedByTheGround) {
  EXPECT_LT(distance_of({{-0.3, 0.2, 0.0}, {-0.3, 4.0, 0.0}}), 0.03);
}

constexpr double kEaves_m = 8.0;

/// A flat roof west of x = 0, whose edge runs across the base. The cloud has no points within half
/// a metre of the edge, so the rays of the edge end on the ground, a metre east.
PointGrid roof_with_a_bare_edge() {
  test::Random random(7);
  std::vector<Eigen::Vector3d> points;
  for (double y = -5.0; y < 10.0; y += 0.4) {
    for (double x = -6.0; x < -0.5; x += 0.4)
      points.emplace_back(x, y, kEaves_m + random.normal(kLidarSigma_m));
    for (double x = -0.3; x < 6.0; x += 0.4)
      points.emplace_back(x, y, random.normal(kLidarSigma_m));
  }
  return PointGrid::build(points.size(), [&](std::size_t i) { return points[i]; });
}

LineEvaluation judged_at_a_bare_edge(double z) {
  JudgedLine line;
  line.id = "edge";
  // the ray of the left image through the edge has the height z here
  const double x = 100.0 / (800.0 - kEaves_m) * (kEaves_m - z);
  line.segment = {{x, 1, z}, {x, 4, z}};
  line.images = seen(line.segment);
  return judge_line(roof_with_a_bare_edge(), line, {}).evaluation;
}

TEST(JudgeAtABareEdge, IsByTheRoofThatTheImagesShowItOn) {
  const LineEvaluation judged = judged_at_a_bare_edge(kEaves_m);
  ASSERT_EQ(judged.status, Status::kEvaluated) << judged.reason;
  EXPECT_LT(*judged.mean_distance_m, 0.03);
}

TEST(JudgeAtABareEdge, OfALineAtAWrongHeightIsByTheGroundThatItsRaysEndOn) {
  for (const double wrong_m : {4.0, 16.0}) {
    const LineEvaluation judged = judged_at_a_bare_edge(wrong_m);
    ASSERT_EQ(judged.status, Status::kEvaluated) << judged.reason;
    EXPECT_NEAR(*judged.mean_distance_m, wrong_m, 0.03);
  }
  const LineEvaluation near_the_roof = judged_at_a_bare_edge(kEaves_m + 0.7);
  ASSERT_EQ(near_the_roof.status, Status::kEvaluated) << near_the_roof.reason;
  EXPECT_NEAR(*near_the_roof.mean_distance_m, 0.7, 0.03);
}

}  // namespace
}  // namespace ridgeline::evaluate
