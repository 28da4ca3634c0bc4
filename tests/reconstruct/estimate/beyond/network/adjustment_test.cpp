// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/network/adjustment.h"

#include "tests/reconstruct/support/conditioned_scene.h"
#include "tests/reconstruct/support/line_group.h"

#include <gtest/gtest.h>

namespace ridgeline::reconstruct {
namespace {

constexpr std::array kAnyHeight_m{-1e5, 1e5};
constexpr double kSigmaSlope = 0.01;

using test::ConditionedScene;

/// Lines of a scene, each observed with errors; they start from the intersections of their planes.
std::vector<NetworkLine> observed_lines(const ConditionedScene& scene,
                                        const std::vector<Segment3>& truth,
                                        test::Random& random) {
  std::vector<NetworkLine> lines;
  for (const Segment3& segment : truth) {
    NetworkLine line;
    line.track = scene.observe(test::noisy_pair(scene.scene, segment, {}, random));
    const UncertainLine3 direct = *intersection(line.track.base().plane, line.track.other().plane);
    line.start = direct.mean;
    line.start_cov = direct.cov;
    lines.push_back(line);
  }
  return lines;
}

std::vector<const NetworkLine*> pointers(const std::vector<NetworkLine>& lines) {
  std::vector<const NetworkLine*> result;
  for (const NetworkLine& line : lines) result.push_back(&line);
  return result;
}

TEST(NetworkAdjustment, OfImagesAloneIsTheIntersectionOfThePlanesWithItsCovariance) {
  constexpr double kRounding = 1e-8;  // the range of heights, 200 km, weighs 1e-10
  const ConditionedScene scene;
  test::Random random(321);
  for (const double theta_deg : {80.0, 30.0, 8.0}) {
    std::vector<NetworkLine> lines =
        observed_lines(scene, {test::make_segment(scene.scene, test::line_at(theta_deg))}, random);
    const UncertainLine3 direct{lines[0].start, *lines[0].start_cov};
    Vector6d away = direct.mean;  // the start must not decide
    away(5) += 1e-3;
    lines[0].start = project_to_pluecker_quadric(away);
    NetworkAdjustment adjustment(scene.frames, pointers(lines), {}, kAnyHeight_m, kSigmaSlope);
    ASSERT_TRUE(adjustment.minimise(1e-9, 50));
    ASSERT_TRUE(adjustment.invert());
    const double sign = adjustment.estimate(0).dot(direct.mean) < 0.0 ? -1.0 : 1.0;
    EXPECT_LT((sign * adjustment.estimate(0) - direct.mean).norm(), kRounding);
    EXPECT_LT((adjustment.covariance(0) - direct.cov).norm(), 1e-5 * direct.cov.norm())
        << theta_deg;
    EXPECT_NEAR(adjustment.image_omega(0), 0.0, kRounding);
  }
}

/// A line that three others meet, and a fourth one that misses it.
class MeetingLines : public testing::Test {
 protected:
  MeetingLines() {
    std::vector<Segment3> truth{test::make_segment(scene.scene, test::line_at(40))};
    for (const auto& [parameter, rise_m] :
         {std::pair(0.1, 3.0), std::pair(0.5, -2.0), std::pair(0.9, 1.0)}) {
      truth.push_back(test::make_neighbour(
          scene.scene, truth[0], {.parameter = parameter, .angle_deg = 110, .rise_m = rise_m}));
    }
    lines = observed_lines(scene, truth, random);
  }
  ConditionedScene scene;
  test::Random random{322};
  std::vector<NetworkLine> lines;
  std::vector<Meeting> meetings{{0, 1, {0.8, 0.1}}, {0, 2, {0.8, 0.1}}, {3, 0, {0.8, 0.1}}};
};

TEST_F(MeetingLines, PredictionOfAMeetingIsThatOfTheAdjustmentWithoutIt) {
  constexpr double kSecondOrder = 0.02;  // the heights of lines move by 2 standard deviations
  NetworkAdjustment all(scene.frames, pointers(lines), meetings, kAnyHeight_m, kSigmaSlope);
  ASSERT_TRUE(all.minimise(1e-9, 50) && all.invert());
  for (std::size_t m = 0; m < meetings.size(); ++m) {
    NetworkAdjustment without(scene.frames, pointers(lines), meetings, kAnyHeight_m, kSigmaSlope);
    without.weights[m] = 0.0;
    ASSERT_TRUE(without.minimise(1e-9, 50) && without.invert());
    const double miss =
        signed_distance(without.estimate(meetings[m].first), without.estimate(meetings[m].second)) *
        scene.frames.object.scale_m / meetings[m].junction.sigma_m;
    EXPECT_NEAR(all.predicted(m).miss, miss, kSecondOrder * (1 + std::abs(miss)));
    EXPECT_NEAR(without.predicted(m).miss, miss, 1e-9);
    EXPECT_NEAR(all.predicted(m).sigma, without.predicted(m).sigma,
                kSecondOrder * without.predicted(m).sigma);
  }
}

TEST_F(MeetingLines, NothingPredictsAMeetingOfALineOfUnknownPrecision) {
  lines[0].start_cov.reset();
  const NetworkAdjustment adjustment(scene.frames, pointers(lines), meetings, kAnyHeight_m,
                                     kSigmaSlope);
  EXPECT_TRUE(std::isinf(adjustment.predicted_at_start(0).sigma));
}

TEST_F(MeetingLines, HaveConvergedOnceAPassMovesNoLineByMoreThanTheTolerance) {
  NetworkAdjustment adjustment(scene.frames, pointers(lines), meetings, kAnyHeight_m, kSigmaSlope);
  EXPECT_FALSE(adjustment.converged());
  ASSERT_TRUE(adjustment.minimise(1e-6, 1));
  EXPECT_FALSE(adjustment.converged());
  ASSERT_TRUE(adjustment.minimise(1e-6, 50));
  EXPECT_TRUE(adjustment.converged());
  // the last call decides, and without a pass it cannot find that the lines have converged
  ASSERT_TRUE(adjustment.minimise(1e-6, 0));
  EXPECT_FALSE(adjustment.converged());
}

TEST_F(MeetingLines, AreMoreCertainThanAlone) {
  NetworkAdjustment alone(scene.frames, pointers(lines), {}, kAnyHeight_m, kSigmaSlope);
  NetworkAdjustment together(scene.frames, pointers(lines), meetings, kAnyHeight_m, kSigmaSlope);
  ASSERT_TRUE(alone.minimise(1e-6, 50) && alone.invert());
  ASSERT_TRUE(together.minimise(1e-6, 50) && together.invert());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_LT(together.covariance(i).trace(), alone.covariance(i).trace());
    EXPECT_GT(together.image_omega(i), 0.0);
  }
}

/// A line far from those of MeetingLines whose images contradict each other.
NetworkLine contradictory_line(const ConditionedScene& scene, test::Random& random) {
  const auto apart_m = [&](double range_m) { return random.uniform(-range_m, range_m); };
  Segment3 one = test::make_segment(scene.scene, test::line_at(random.uniform(2.0, 85.0)));
  one.start.z() += 40.0;
  one.end.z() += 40.0;
  const Eigen::Vector3d moved_m(apart_m(3.0), apart_m(3.0), apart_m(5.0));
  const Segment3 other{one.start + moved_m, one.end - moved_m};
  NetworkLine line = observed_lines(scene, {one}, random)[0];
  for (const ObservedLine& seen : scene.observe(test::exact_pair(scene.scene, other)).observations)
    line.track.observations.push_back(seen);
  return line;
}

TEST_F(MeetingLines, AreAdjustedWithoutALineThatDoesNotConverge) {
  constexpr int kMaxTries = 20000;  // few contradictory lines do not converge
  constexpr double kConvergence = 1e-6;
  const auto adjusted = [&] {
    return adjust_network(scene.frames, lines, meetings, kAnyHeight_m, {});
  };
  const std::vector<AdjustedInNetwork> before = adjusted();
  meetings.push_back({0, 4, {0.8, 0.1}});  // offered, but too far apart to be accepted
  lines.emplace_back();
  for (int i = 0; i < kMaxTries; ++i) {
    lines.back() = contradictory_line(scene, random);
    const std::vector<AdjustedInNetwork> after = adjusted();
    if (after[4].adjusted) continue;
    for (std::size_t k = 0; k < before.size(); ++k) {
      ASSERT_TRUE(after[k].adjusted);
      EXPECT_EQ(after[k].n_meetings, before[k].n_meetings);
      EXPECT_LT((after[k].line.mean - before[k].line.mean).norm(), kConvergence);
    }
    return;
  }
  FAIL() << "every line converged";
}

}  // namespace
}  // namespace ridgeline::reconstruct
