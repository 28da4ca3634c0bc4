// SPDX-License-Identifier: BSD-3-Clause
// The horizontal and vertical parts of how far ridges and hips lie from their roofs, over whole
// simulated villages whose true lines are moved by known vectors; 5 points/m2, noise of 3.4 cm.
#include "evaluate/judge/ridge_displacement.h"
#include "tests/acceptance/simulated_survey.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

namespace ridgeline::test {
namespace {

using evaluate::LineEvaluation;
using evaluate::RidgeDisplacement;

constexpr std::uint64_t kFirstSeed = 101;  // no seed that anything was chosen on
constexpr int kVillages = 20;
constexpr double kDensity_per_m2 = 5.0;

/// What the movement of a line does to it: across in plan, and in height at the same place in plan.
Eigen::Vector2d true_parts(const Segment3& line, const Eigen::Vector3d& move_m) {
  const Eigen::Vector3d d = line.end - line.start;
  const Eigen::Vector2d u = d.head<2>().normalized();
  const double slope = d.z() / d.head<2>().norm();
  Eigen::Vector2d h(-u.y(), u.x());
  if (h.x() < 0.0 || (h.x() == 0.0 && h.y() < 0.0)) h = -h;
  return {move_m.head<2>().dot(h), move_m.z() - move_m.head<2>().dot(u) * slope};
}

double angle_deg(const LineEvaluation& e) {
  return acute_angle_rad(Eigen::Vector3d(e.planes[0].plane.normal()),
                         Eigen::Vector3d(e.planes[1].plane.normal())) *
         180.0 / std::numbers::pi;
}

struct Tally {
  int n = 0, n_within_3_cm = 0;
  std::array<int, 2> n_covered{};  ///< by the 95 % intervals of horizontal and vertical
  double sum_z2 = 0.0;             ///< of both parts by their covariance

  [[nodiscard]] double percent(int count) const { return 100.0 * count / n; }
};

void add(const RidgeDisplacement& d, const Eigen::Vector2d& truth, Tally& tally) {
  constexpr double kRight_m = 0.03;
  constexpr double k95 = 1.96;
  const Eigen::Vector2d error = Eigen::Vector2d(d.horizontal_m, d.vertical_m) - truth;
  ++tally.n;
  if (error.cwiseAbs().maxCoeff() <= kRight_m) ++tally.n_within_3_cm;
  for (int i = 0; i < 2; ++i) {
    const bool is_covered = std::abs(error[i]) <= k95 * std::sqrt(d.covariance_m2(i, i));
    if (is_covered) ++tally.n_covered[static_cast<std::size_t>(i)];
  }
  tally.sum_z2 += error.dot(d.covariance_m2.inverse() * error);
}

struct Tallies {
  Tally steep, flat;
};

Tallies judge_villages(const Eigen::Vector3d& move_m) {
  constexpr double kSteep_deg = 60.0;
  Tallies tallies;
  for (int i = 0; i < kVillages; ++i) {
    const SimulatedSurvey survey = simulated_survey(kFirstSeed + i, kDensity_per_m2);
    const auto results = judge_survey(survey, move_m);
    for (std::size_t k = 0; k < results.size(); ++k) {
      const LineEvaluation& e = results[k].evaluation;
      if (!e.displacement || survey.scene.lines[k].plane_ids.size() != 2) continue;
      add(*e.displacement, true_parts(survey.scene.lines[k].segment, move_m),
          angle_deg(e) >= kSteep_deg ? tallies.steep : tallies.flat);
    }
  }
  return tallies;
}

void record(const std::string& name, const Tally& tally) {
  const auto property = [&](const std::string& figure, double value) {
    ::testing::Test::RecordProperty(name + "_" + figure, std::to_string(value));
  };
  property("ridges", tally.n);
  property("within_3_cm_percent", tally.percent(tally.n_within_3_cm));
  property("horizontal_covered_percent", tally.percent(tally.n_covered[0]));
  property("vertical_covered_percent", tally.percent(tally.n_covered[1]));
  property("mean_z2_per_dof", tally.sum_z2 / (2.0 * tally.n));
}

class RidgeParts : public testing::TestWithParam<Eigen::Vector3d> {};

TEST_P(RidgeParts, AreThoseOfTheMovement) {
  constexpr double kMinWithin3Cm_percent = 95.0;
  constexpr double kMinCoverage_percent = 92.0, kMaxCoverage_percent = 98.0;
  constexpr int kEnough = 150;  // a share of 95 % is then known to 1.8 %
  const Tallies tallies = judge_villages(GetParam());
  record("steep", tallies.steep);
  record("flat", tallies.flat);
  ASSERT_GE(tallies.steep.n, kEnough);
  ASSERT_GE(tallies.flat.n, kEnough);
  EXPECT_GE(tallies.steep.percent(tallies.steep.n_within_3_cm), kMinWithin3Cm_percent);
  for (const int n : tallies.flat.n_covered) {
    EXPECT_GE(tallies.flat.percent(n), kMinCoverage_percent);
    EXPECT_LE(tallies.flat.percent(n), kMaxCoverage_percent);
  }
}

INSTANTIATE_TEST_SUITE_P(Movements,
                         RidgeParts,
                         testing::Values(Eigen::Vector3d(0.0, 0.0, 0.0),
                                         Eigen::Vector3d(0.2, -0.15, 0.4),
                                         Eigen::Vector3d(-0.3, 0.3, -0.1)));

}  // namespace
}  // namespace ridgeline::test
