// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/constant_shift.h"

#include "evaluate/probability.h"
#include "evaluate/tables/evaluation_json.h"
#include "evaluate/tables/shift_json.h"
#include "evaluate/tables/shift_text.h"
#include "evaluate/tables/table2.h"
#include "tests/evaluate/statistics/lines.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>

#include <numbers>

namespace ridgeline::evaluate {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kLidarAccuracy_m = 0.034;
constexpr double kExact_m = 1e-9;  // rounding of a few sums
const Eigen::Vector3d kShift(0.3, -0.2, 0.45);

/// The upward unit normal of a plane that falls towards an azimuth.
Eigen::Vector3d falling(double azimuth_deg, double slope_deg) {
  const double azimuth = azimuth_deg * std::numbers::pi / 180.0;
  const double slope = slope_deg * std::numbers::pi / 180.0;
  return {std::sin(slope) * std::sin(azimuth), std::sin(slope) * std::cos(azimuth),
          std::cos(slope)};
}

/// A line at a signed distance from a plane with this normal.
LineEvaluation line_beside(const Eigen::Vector3d& normal,
                           double distance_m,
                           std::uint64_t plane_id) {
  LineEvaluation line = evaluated_line(std::to_string(plane_id), distance_m, plane_id);
  line.planes[0].plane = Plane3(normal, 0.0);
  return line;
}

/// Lines beside gabled houses, whose ridges have these azimuths, and on the ground. The error of a
/// line along the normal is one of its house and one of its own.
std::vector<LineEvaluation> houses(const std::vector<double>& azimuths_deg,
                                   const Eigen::Vector3d& shift_m,
                                   double house_sigma_m = 0.0,
                                   double line_sigma_m = 0.0,
                                   std::uint64_t seed = 1) {
  test::Random random(seed);
  std::vector<LineEvaluation> lines;
  std::uint64_t id = 0;
  const auto add = [&](const Eigen::Vector3d& normal, const Eigen::Vector3d& error_m,
                       std::string house) {
    const double d = normal.dot(shift_m + error_m) + random.normal(line_sigma_m);
    lines.push_back(line_beside(normal, d, ++id));
    lines.back().building = std::move(house);
  };
  for (std::size_t house = 0; house < azimuths_deg.size(); ++house) {
    const Eigen::Vector3d error_m(random.normal(house_sigma_m), random.normal(house_sigma_m),
                                  random.normal(house_sigma_m));
    for (const double side_deg : {90.0, -90.0}) {
      for (int i = 0; i < 3; ++i)
        add(falling(azimuths_deg[house] + side_deg, 35.0), error_m, std::to_string(house));
    }
    add(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(), "");
  }
  return lines;
}

const std::vector<double> kStreets{0, 90, 3, 93, -2, 88, 1, 91, 0, 92, 2, 90};

TEST(EstimateShift, IsExactWithoutErrors) {
  const ConstantShift shift = estimate_shift(houses(kStreets, kShift), kLidarAccuracy_m).value();
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(shift.axes[static_cast<std::size_t>(axis)].shift_m.value(), kShift[axis], kExact_m);
  EXPECT_TRUE(shift.unobservable.empty());
  EXPECT_NEAR(shift.least_m, kShift.norm(), kExact_m);
  EXPECT_TRUE(shift.is_significant());
  EXPECT_EQ(shift.n_lines, 7 * kStreets.size());
  EXPECT_EQ(shift.n_clusters, 2 * kStreets.size());
}

TEST(EstimateShift, IsNotDrawnByLinesOnWrongPlanes) {
  std::vector<LineEvaluation> lines = houses(kStreets, kShift);
  for (std::size_t i = 0; i < lines.size(); i += 4) {  // a quarter, all to one side
    lines[i].planes[0].distance.mean += 1.0 + 0.1 * static_cast<double>(i);
  }
  const ConstantShift shift = estimate_shift(lines, kLidarAccuracy_m).value();
  EXPECT_LT((shift.shift_m - kShift).norm(), kExact_m);
}

TEST(EstimateShift, OfFlatPlanesIsAHeightAlone) {
  std::vector<LineEvaluation> lines;
  for (std::uint64_t id = 1; id <= 40; ++id)
    lines.push_back(line_beside(falling(37.0 * static_cast<double>(id), 0.7), 0.2, id));
  const ConstantShift shift = estimate_shift(lines, kLidarAccuracy_m).value();
  EXPECT_FALSE(shift.axes[0].shift_m.has_value());
  EXPECT_FALSE(shift.axes[1].shift_m.has_value());
  EXPECT_NEAR(shift.axes[2].shift_m.value(), 0.2, 1e-3);  // the planes are a little tilted
  EXPECT_EQ(shift.unobservable.size(), 2U);
  const std::string json = shift_json(shift)["axes"].dump();
  EXPECT_THAT(json, HasSubstr("\"x\":null,\"y\":null"));
  EXPECT_THAT(shift_text(shift), HasSubstr("x, y not observable from these planes"));
}

TEST(EstimateShift, OfNearlyFlatPlanesTakesNoPlanFromALargeHeight) {
  std::vector<LineEvaluation> lines;
  for (std::uint64_t id = 1; id <= 40; ++id) {  // a slope of 3 degrees to the north, more or less
    const Eigen::Vector3d normal =
        falling(9.0 * static_cast<double>(id % 3), 2.5 + 0.025 * static_cast<double>(id));
    lines.push_back(line_beside(normal, 48.0 * normal.z(), id));
  }
  const ConstantShift shift = estimate_shift(lines, kLidarAccuracy_m).value();
  EXPECT_LT((shift.shift_m - Eigen::Vector3d(0.0, 0.0, 48.0)).norm(), kExact_m);
}

TEST(EstimateShift, OfParallelRidgesTellsThePlanAcrossThem) {
  const std::vector<double> parallel(12, 30.0);
  const ConstantShift shift = estimate_shift(houses(parallel, kShift), kLidarAccuracy_m).value();
  ASSERT_EQ(shift.unobservable.size(), 1U);
  const Eigen::Vector3d along(0.5, std::sqrt(0.75), 0.0);
  EXPECT_NEAR(std::abs(shift.unobservable[0].dot(along)), 1.0, kExact_m);
  EXPECT_FALSE(shift.axes[0].shift_m || shift.axes[1].shift_m);
  EXPECT_NEAR(shift.axes[2].shift_m.value(), kShift.z(), kExact_m);
  EXPECT_LT((shift.shift_m - (kShift - along * along.dot(kShift))).norm(), kExact_m);
  EXPECT_THAT(shift_text(shift), HasSubstr("towards azimuth 120 degrees 0.360 +- 0.000 m"));
}

TEST(EstimateShift, OfOneSlopeIsTheDistanceFromIt) {
  std::vector<LineEvaluation> lines;
  for (std::uint64_t id = 1; id <= 20; ++id)
    lines.push_back(line_beside(falling(180.0, 30.0), 0.25, id));
  const ConstantShift shift = estimate_shift(lines, kLidarAccuracy_m).value();
  EXPECT_EQ(shift.unobservable.size(), 2U);
  EXPECT_LT((shift.shift_m - 0.25 * falling(180.0, 30.0)).norm(), kExact_m);
  EXPECT_THAT(shift_text(shift), HasSubstr("along (0.00, -0.50, 0.87) 0.250 +- 0.000 m"));
}

TEST(EstimateShift, DoesNotTakeAnAxisFromOneHouseAlone) {
  std::vector<double> azimuths_deg(12, 0.0);
  azimuths_deg.back() = 90.0;
  const ConstantShift shift =
      estimate_shift(houses(azimuths_deg, kShift), kLidarAccuracy_m).value();
  EXPECT_TRUE(shift.axes[0].shift_m.has_value());
  EXPECT_FALSE(shift.axes[1].shift_m.has_value());
}

TEST(EstimateShift, IsNoneWithoutJudgedLines) {
  EXPECT_FALSE(estimate_shift({}, kLidarAccuracy_m).has_value());
  const std::vector<LineEvaluation> excluded{excluded_line("1", Status::kNoPlane)};
  EXPECT_FALSE(estimate_shift(excluded, kLidarAccuracy_m).has_value());
  EXPECT_THROW(estimate_shift({}, -1.0), std::invalid_argument);
}

TEST(EstimateShift, BelowTheAccuracyOfTheLidarIsNotSignificant) {
  const Eigen::Vector3d small(0.02, 0.0, 0.02);
  const auto lines = houses(kStreets, small, 0.001, 0.001);
  const ConstantShift shift = estimate_shift(lines, kLidarAccuracy_m).value();
  EXPECT_GT(shift.axes[2].ci95_m->low, 0.0) << "it is no chance";
  EXPECT_FALSE(shift.is_significant());
  EXPECT_TRUE(estimate_shift(lines, 0.01).value().is_significant());
}

TEST(EstimateShift, StatesItsErrorsWhereLinesOfAHouseErrTogether) {
  constexpr int kRuns = 400;
  std::vector<double> azimuths_deg;
  for (int i = 0; i < 40; ++i) azimuths_deg.push_back(i % 2 == 0 ? 0.0 : 90.0);
  double nees = 0.0;
  std::array<int, 3> n_held{};
  int n_alarms = 0;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    const auto lines = houses(azimuths_deg, kShift, 0.08, 0.05, run + 1);
    const ConstantShift shift = estimate_shift(lines, kLidarAccuracy_m).value();
    const Eigen::Vector3d error = shift.shift_m - kShift;
    nees += error.dot(shift.covariance_m2.inverse() * error) / (3.0 * kRuns);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Interval ci = shift.axes[axis].ci95_m.value();
      const double truth = kShift[static_cast<Eigen::Index>(axis)];
      n_held[axis] += ci.low <= truth && truth <= ci.high ? 1 : 0;
    }
    const auto unshifted = houses(azimuths_deg, Eigen::Vector3d::Zero(), 0.08, 0.05, run + 1);
    n_alarms += estimate_shift(unshifted, kLidarAccuracy_m).value().is_significant() ? 1 : 0;
  }
  // The scatter of the mean over 1200 values is 0.04. The covariance is that of a jackknife, which
  // is a little too large, and is widened for few clusters.
  EXPECT_GT(nees, 0.65);
  EXPECT_LT(nees, 1.15);
  for (const int held : n_held) EXPECT_GE(held, 372);  // 93 % of 400; 95 % less two standard errors
  EXPECT_LE(n_alarms, 20);                             // 5 %
}

TEST(LeastNorm, IsThatOfTheNearestPointOfTheRegion) {
  const Eigen::Matrix3d round = 0.04 * Eigen::Matrix3d::Identity();
  EXPECT_NEAR(least_norm({3.0, 0.0, 4.0}, round, 4.0), 5.0 - 0.2 * 2.0, kExact_m);
  EXPECT_EQ(least_norm({0.1, 0.0, 0.1}, round, 4.0), 0.0);
  // x is exact, y is free within 5: (1, 0, 0) is the nearest
  const Eigen::Matrix3d flat = Eigen::Vector3d(0.0, 25.0, 0.0).asDiagonal();
  EXPECT_NEAR(least_norm({1.0, 2.0, 0.0}, flat, 1.0), 1.0, kExact_m);
  EXPECT_NEAR(least_norm({1.0, 2.0, 2.0}, Eigen::Matrix3d::Zero(), 1.0), 3.0, kExact_m);
  // an ellipse: the nearest point, by steps around it
  const Eigen::Matrix3d long_y = Eigen::Vector3d(0.01, 1.0, 0.0).asDiagonal();
  double nearest = 10.0;
  for (int i = 0; i < 100000; ++i) {
    const double angle = 2e-5 * std::numbers::pi * i;
    nearest = std::min(nearest, std::hypot(0.5 + 0.1 * std::cos(angle), 1.5 + std::sin(angle)));
  }
  EXPECT_NEAR(least_norm({0.5, 1.5, 0.0}, long_y, 1.0), nearest, 1e-8);
}

TEST(FigureOfShift, ComesBackFromJson) {
  Evaluation evaluation;
  evaluation.patch = "1";
  evaluation.method = "joint";
  evaluation.lines = houses({30, 30, 30}, kShift, 0.01, 0.01);
  evaluation.shift = estimate_shift(evaluation.lines, kLidarAccuracy_m);
  evaluation.shift->cause = "a cause";
  evaluation.shift->applied = true;
  const Evaluation read = parse_evaluation(to_json(with_summaries(evaluation)));
  EXPECT_EQ(shift_json(read.shift), shift_json(evaluation.shift));
  evaluation.shift.reset();
  EXPECT_FALSE(parse_evaluation(to_json(with_summaries(evaluation))).shift.has_value());
}

TEST(FigureOfShift, StandsInEveryTableOfMovedLines) {
  Evaluation evaluation;
  evaluation.patch = "1";
  evaluation.method = "joint";
  evaluation.lines = houses(kStreets, kShift);
  evaluation.shift = estimate_shift(evaluation.lines, kLidarAccuracy_m);
  const auto texts = [&] {
    const std::vector<Evaluation> all{with_summaries(evaluation)};
    const Table2 table = make_table2(all);
    return std::vector<std::string>{to_markdown(table), to_latex(table), to_json(table),
                                    to_csv(table), to_line_csv(all.front())};
  };
  for (const std::string& text : texts()) EXPECT_THAT(text, Not(HasSubstr("moved")));
  EXPECT_THAT(shift_messages(std::vector{evaluation}, false).at(0),
              HasSubstr("`apply_shift` judges the lines without it"));
  evaluation.shift->applied = true;
  for (const std::string& text : texts()) EXPECT_THAT(text, HasSubstr("moved"));
  EXPECT_THAT(texts()[0], HasSubstr("moved by x -0.300, y 0.200, z -0.450 m"));
  EXPECT_THAT(texts()[3], HasSubstr("rms_points_place_m,moved_x_m,moved_y_m,moved_z_m\n"));
  EXPECT_THAT(texts()[3], HasSubstr(",-0.300,0.200,-0.450\n"));
}

}  // namespace
}  // namespace ridgeline::evaluate
