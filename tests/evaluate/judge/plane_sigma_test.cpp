// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plane_sigma.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kSigma_m = 0.034;

/// A level strip of 12 m by 4 m whose points err by `alone_m` each and by `together_m` with all in
/// their square metre.
std::vector<ZonePoint> strip(int n, double alone_m, double together_m, test::Random& random) {
  std::array<std::array<double, 4>, 12> common{};
  for (auto& column : common) {
    for (double& error_m : column) error_m = random.normal(together_m);
  }
  std::vector<ZonePoint> points;
  for (int i = 0; i < n; ++i) {
    const double s = random.uniform(0.0, 12.0);
    const double t = random.uniform(0.0, 4.0);
    const double z =
        random.normal(alone_m) + common[static_cast<std::size_t>(s)][static_cast<std::size_t>(t)];
    points.push_back({{s, t, z}, s, t, static_cast<std::uint32_t>(i)});
  }
  return points;
}

/// Share of fits whose 95 % interval at the border of the strip holds the true height, percent.
template <typename Sigma>
double covered_percent(int n, double alone_m, double together_m, const Sigma& sigma_m) {
  constexpr int kTrials = 2000;
  const Eigen::Vector3d at_line(6.0, 0.0, 0.0);
  test::Random random(5);
  int n_covered = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const std::vector<ZonePoint> points = strip(n, alone_m, together_m, random);
    std::vector<Eigen::Vector3d> x;
    for (const ZonePoint& p : points) x.push_back(p.x);
    const auto fit = fit_plane(x);
    const double error_m = std::abs(fit->plane.signedDistance(at_line));
    if (error_m <= 1.96 * sigma_m(*fit, points, at_line)) ++n_covered;
  }
  return 100.0 * n_covered / kTrials;
}

double ours(const PlaneFit& fit, const std::vector<ZonePoint>& points, const Eigen::Vector3d& x) {
  return plane_sigma_m(fit, points, x);
}
double as_if_independent(const PlaneFit& fit,
                         const std::vector<ZonePoint>&,
                         const Eigen::Vector3d& x) {
  return fit.sigma_at(x);
}

TEST(PlaneSigma, HoldsForIndependentErrors) {
  // the larger of two estimates is a little too large
  const double percent = covered_percent(240, kSigma_m, 0.0, ours);
  EXPECT_GE(percent, 94.0);
  EXPECT_LE(percent, 98.0);
}

TEST(PlaneSigma, HoldsForNeighboursThatErrTogether) {
  EXPECT_LE(covered_percent(240, kSigma_m, 0.02, as_if_independent), 85.0);
  const double percent = covered_percent(240, kSigma_m, 0.02, ours);
  EXPECT_GE(percent, 92.0);
  EXPECT_LE(percent, 98.0);
}

TEST(PlaneSigma, HoldsForFewPoints) {
  EXPECT_LE(covered_percent(5, kSigma_m, 0.0, as_if_independent), 85.0);
  const double percent = covered_percent(5, kSigma_m, 0.0, ours);
  EXPECT_GE(percent, 93.0);
  EXPECT_LE(percent, 99.0);
}

TEST(PlaneSigma, IsZeroWithoutNoise) {
  test::Random random(2);
  const std::vector<ZonePoint> points = strip(50, 0.0, 0.0, random);
  std::vector<Eigen::Vector3d> x;
  for (const ZonePoint& p : points) x.push_back(p.x);
  EXPECT_NEAR(plane_sigma_m(*fit_plane(x), points, {6.0, 0.0, 0.0}), 0.0, 1e-12);
}

}  // namespace
}  // namespace ridgeline::evaluate
