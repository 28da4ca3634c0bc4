// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/interval.h"

#include "evaluate/statistics/bootstrap.h"
#include "evaluate/statistics/distribution.h"
#include "tests/evaluate/statistics/lines.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kIntervalTol = 1e-12;

TEST(ChiSquareRmsInterval, IsMinus24Plus44PercentFor20Values) {
  const Interval ci = *chi_square_rms_interval(1.0, 20);
  // chi2_{20}: 9.591 and 34.170 (printed tables); the stated percentages are rounded
  EXPECT_NEAR(ci.low, std::sqrt(20.0 / 34.170), 1e-4);
  EXPECT_NEAR(ci.high, std::sqrt(20.0 / 9.591), 1e-4);
  EXPECT_NEAR(ci.low, 1.0 - 0.24, 0.006);
  EXPECT_NEAR(ci.high, 1.0 + 0.44, 0.006);
  EXPECT_NEAR(chi_square_rms_interval(0.3, 20)->high, 0.3 * ci.high, kIntervalTol);
}

TEST(ChiSquareRmsInterval, HasNoAnswerWithoutFreedomAndRejectsNonsense) {
  EXPECT_FALSE(chi_square_rms_interval(1.0, 0));
  EXPECT_THROW(chi_square_rms_interval(-1.0, 5), std::invalid_argument);
  EXPECT_THROW(chi_square_rms_interval(1.0, 5, 1.0), std::invalid_argument);
}

TEST(ChiSquareRatioBounds, EncloseOneAndNarrowWithTheDegreesOfFreedom) {
  // chi2_{10}: 3.247 and 20.483 (printed tables)
  const Interval ten = *chi_square_ratio_bounds(10);
  EXPECT_NEAR(ten.low, 0.3247, 1e-4);
  EXPECT_NEAR(ten.high, 2.0483, 1e-4);
  const Interval many = *chi_square_ratio_bounds(1000);
  EXPECT_LT(ten.low, many.low);
  EXPECT_LT(many.low, 1.0);
  EXPECT_GT(many.high, 1.0);
  EXPECT_LT(many.high, ten.high);
}

TEST(WilsonInterval, HandCheckedCases) {
  // 8 of 10: (0.8 + z^2/20 -+ z sqrt(0.016 + z^2/400)) / (1 + z^2/10), z^2 = 3.841459
  const Interval eight = *wilson_interval(8, 10);
  EXPECT_NEAR(eight.low, 0.490162, 1e-6);
  EXPECT_NEAR(eight.high, 0.943318, 1e-6);
  const Interval none = *wilson_interval(0, 10);
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 3.841459 / 13.841459, 1e-6);
  EXPECT_EQ(wilson_interval(10, 10)->high, 1.0);
  EXPECT_FALSE(wilson_interval(0, 0));
  EXPECT_THROW(wilson_interval(2, 1), std::invalid_argument);
}

TEST(ClusterLabels, JoinLinesThatSharePlanesOrABuilding) {
  std::vector<LineEvaluation> lines{evaluated_line("a", 0, 1), evaluated_line("b", 0, 2),
                                    evaluated_line("c", 0, 1), evaluated_line("d", 0, 3),
                                    excluded_line("e", Status::kNoPlane)};
  EXPECT_EQ(cluster_labels(lines), (std::vector<std::size_t>{0, 1, 0, 2, 3}));
  lines[2].planes.push_back(evaluated_line("", 0, 2).planes[0]);  // c: a ridge of planes 1 and 2
  EXPECT_EQ(cluster_labels(lines), (std::vector<std::size_t>{0, 0, 0, 1, 2}));
  lines[0].building = lines[3].building = "house";
  EXPECT_EQ(cluster_labels(lines), (std::vector<std::size_t>{0, 1, 1, 0, 2}));
}

TEST(ClusterLabels, DoNotJoinPlanesWithoutAnId) {
  const std::vector lines{evaluated_line("a", 0, 0), evaluated_line("b", 0, 0)};
  EXPECT_EQ(cluster_labels(lines), (std::vector<std::size_t>{0, 1}));
}

/// Errors of `n_clusters` roofs of 4 lines: a common part and one of each line, both N(0, 0.1^2).
struct RoofErrors {
  std::vector<double> errors;
  std::vector<std::size_t> clusters;
};

RoofErrors simulate_roofs(std::size_t n_clusters, std::mt19937_64& rng) {
  std::normal_distribution<double> normal(0.0, 0.1);
  RoofErrors result;
  for (std::size_t c = 0; c < n_clusters; ++c) {
    const double common = normal(rng);
    for (int i = 0; i < 4; ++i) {
      result.errors.push_back(common + normal(rng));
      result.clusters.push_back(c);
    }
  }
  return result;
}

TEST(BootstrapRms, CoversTheTruthWhereLinesOfARoofAreDependent) {
  constexpr int kTrials = 400;
  const double truth = std::sqrt(0.02);
  std::mt19937_64 rng(4);
  for (const bool bca : {false, true}) {
    const BootstrapOptions options{.replicates = 400, .bca = bca};
    int n_clustered = 0;
    int n_chi_square = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const RoofErrors roofs = simulate_roofs(40, rng);
      const auto covers = [&](const std::optional<Interval>& ci) {
        return ci->low <= truth && truth <= ci->high;
      };
      if (covers(bootstrap_rms(roofs.errors, roofs.clusters, options))) ++n_clustered;
      const double rms = std::sqrt(sum_of_squares(roofs.errors) / 160.0);
      if (covers(chi_square_rms_interval(rms, roofs.errors.size()))) ++n_chi_square;
    }
    // The coverage is known to be slightly short of 95 % for 40 clusters; 3 sigma of 400 trials is
    // 0.04.
    EXPECT_NEAR(n_clustered / double{kTrials}, 0.93, 0.04) << bca;
    EXPECT_LT(n_chi_square, n_clustered) << "independence is the wrong assumption here";
  }
}

TEST(BootstrapRms, IsTheSameForAnyNumberOfThreads) {
  std::mt19937_64 rng(6);
  const RoofErrors roofs = simulate_roofs(25, rng);
  const auto interval_with = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return *bootstrap_rms(roofs.errors, roofs.clusters, {});
  };
  const Interval one = interval_with(1);
  const Interval four = interval_with(4);
  EXPECT_EQ(one.low, four.low);
  EXPECT_EQ(one.high, four.high);
  BootstrapOptions other_seed;
  other_seed.seed = 2;
  EXPECT_NE(bootstrap_rms(roofs.errors, roofs.clusters, other_seed)->low, one.low);
}

TEST(BootstrapRms, NeedsTwoClusters) {
  EXPECT_FALSE(bootstrap_rms(std::vector{0.1, 0.2}, std::vector<std::size_t>{7, 7}, {}));
  EXPECT_FALSE(bootstrap_rms({}, {}, {}));
  const Interval equal = *bootstrap_rms(std::vector{0.1, -0.1}, std::vector<std::size_t>{3, 9}, {});
  EXPECT_NEAR(equal.low, 0.1, kIntervalTol);
  EXPECT_NEAR(equal.high, 0.1, kIntervalTol);
}

TEST(BootstrapRms, BcaAgreesWithPercentilesWhereNothingIsSkewed) {
  const BootstrapOptions bca{.bca = true};
  const Interval equal =
      *bootstrap_rms(std::vector{0.1, -0.1}, std::vector<std::size_t>{3, 9}, bca);
  EXPECT_NEAR(equal.low, 0.1, kIntervalTol);
  EXPECT_NEAR(equal.high, 0.1, kIntervalTol);
}

TEST(ClusteredBootstrap, RejectsWrongOptions) {
  const std::vector errors{0.1, 0.2};
  const std::vector<std::size_t> clusters{0, 1};
  EXPECT_THROW(bootstrap_rms(errors, clusters, {.replicates = 0}), std::invalid_argument);
  EXPECT_THROW(bootstrap_rms(errors, clusters, {.level = 1.0}), std::invalid_argument);
  EXPECT_THROW(bootstrap_rms(errors, std::vector<std::size_t>{0}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::evaluate
