// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/tolerance_measures.h"

#include "evaluate/statistics/parameter_intervals.h"
#include "tests/evaluate/statistics/lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

constexpr double kMeasureTol = 1e-12;

Segment3 along_x(double x0, double x1, double y = 0.0, double z = 0.0) {
  return {{x0, y, z}, {x1, y, z}};
}

ToleranceMeasures against_lines(const std::vector<Segment3>& lines,
                                const std::vector<Segment3>& references,
                                double tolerance_m) {
  ToleranceOptions options;
  options.tolerances_m = {tolerance_m};
  return measure_against_lines(lines, references, options).at(0);
}

TEST(PartNear, ClampsAtTheEndsOfTheReference) {
  const std::optional<ParameterInterval> part = part_near(along_x(0, 20), along_x(5, 10), 1.0);
  ASSERT_TRUE(part);
  EXPECT_NEAR(part->begin, 4.0 / 20.0, kMeasureTol);
  EXPECT_NEAR(part->end, 11.0 / 20.0, kMeasureTol);
  EXPECT_FALSE(part_near(along_x(21, 30), along_x(5, 10), 1.0)) << "collinear, but beyond";
}

TEST(PartNear, TakesSegmentsWithoutLengthAsPoints) {
  const Segment3 point{{3, 0, 0}, {3, 0, 0}};
  EXPECT_TRUE(part_near(point, along_x(0, 10, 0.5), 1.0));
  EXPECT_FALSE(part_near(point, along_x(0, 10, 1.5), 1.0));
  EXPECT_NEAR(part_near(along_x(0, 10), point, 1.0)->begin, 0.2, kMeasureTol);
}

TEST(PartNear, AgreesWithSampling) {
  std::mt19937_64 rng(2);
  std::uniform_real_distribution<double> uniform(-3.0, 3.0);
  const auto point = [&] { return Eigen::Vector3d(uniform(rng), uniform(rng), uniform(rng)); };
  constexpr int kSamples = 1000;
  int n_near = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    SCOPED_TRACE(trial);
    const Segment3 s{point(), point()};
    const Segment3 reference{point(), point()};
    const std::optional<ParameterInterval> part = part_near(s, reference, 1.0);
    int expected = 0;
    for (int k = 0; k < kSamples; ++k) {
      if (distance(reference, point_at(s, (k + 0.5) / kSamples)) <= 1.0) ++expected;
    }
    const int actual = part ? count_samples({*part}, kSamples) : 0;
    EXPECT_EQ(actual, expected);
    if (expected > 0) ++n_near;
  }
  EXPECT_GT(n_near, 100) << "the trials must include near segments";
}

TEST(Join, CountsOverlapsOnce) {
  const auto joined = join({{0.5, 0.7}, {0.0, 0.2}, {0.1, 0.3}, {0.3, 0.4}});
  ASSERT_EQ(joined.size(), 2U);
  EXPECT_NEAR(total_length(joined), 0.6, kMeasureTol);
  EXPECT_TRUE(join({}).empty());
}

TEST(CountSamples, CountsMidpointsOfThousandths) {
  EXPECT_EQ(count_samples({{0.0, 1.0}}, 1000), 1000);
  EXPECT_EQ(count_samples({{0.0, 0.5}}, 1000), 500);
  EXPECT_EQ(count_samples({{0.25, 0.2504}}, 1000), 0);
}

TEST(MeasureAgainstLines, HandCheckedCase) {
  // 10 m of line, 6 m of it along the first of two reference lines of 8 m each.
  const ToleranceMeasures m =
      against_lines({along_x(2, 12, 0.3)}, {along_x(0, 8), along_x(0, 8, 50)}, 0.5);
  const double reach = std::sqrt(0.25 - 0.09);  // beyond the end of the reference
  EXPECT_NEAR(*m.precision, (6.0 + reach) / 10.0, kMeasureTol);
  EXPECT_NEAR(*m.completeness, (6.0 + reach) / 16.0, kMeasureTol);
  EXPECT_NEAR(*m.f_score, 2.0 * *m.precision * *m.completeness / (*m.precision + *m.completeness),
              kMeasureTol);
  EXPECT_NEAR(m.limap_r_m, 6.4, 0.008 * 2) << "one sample of 8 mm at either end";
  EXPECT_NEAR(*m.limap_p_percent, 100.0, kMeasureTol);
}

TEST(MeasureAgainstLines, DuplicatesDoNotRaiseCompleteness) {
  const std::vector<Segment3> references{along_x(0, 10)};
  const ToleranceMeasures one = against_lines({along_x(0, 4)}, references, 0.1);
  const ToleranceMeasures two = against_lines({along_x(0, 4), along_x(0, 4)}, references, 0.1);
  EXPECT_NEAR(*two.completeness, *one.completeness, kMeasureTol);
  EXPECT_NEAR(*two.redundancy, 2.0 * *one.redundancy, kMeasureTol);
}

TEST(MeasureAgainstLines, AsksForTheSameDirection) {
  const Segment3 across{{5, -0.1, 0}, {5, 0.1, 0}};
  const ToleranceMeasures m = against_lines({across}, {along_x(0, 10)}, 0.2);
  EXPECT_EQ(*m.precision, 0.0);
  EXPECT_EQ(*m.completeness, 0.0);
  EXPECT_EQ(*m.f_score, 0.0);
  EXPECT_EQ(*m.limap_p_percent, 100.0) << "LIMAP's figures have no such condition";
  EXPECT_FALSE(m.redundancy);
}

TEST(MeasureAgainstLines, HasNoFigureWithoutLinesOrReferences) {
  const ToleranceMeasures no_lines = against_lines({}, {along_x(0, 1)}, 0.1);
  EXPECT_FALSE(no_lines.precision || no_lines.f_score || no_lines.limap_p_percent);
  EXPECT_EQ(*no_lines.completeness, 0.0);
  const ToleranceMeasures no_references = against_lines({along_x(0, 1)}, {}, 0.1);
  EXPECT_EQ(*no_references.precision, 0.0);
  EXPECT_FALSE(no_references.completeness);
}

TEST(MeasureAgainstLines, RejectsWhatCannotBeMeasured) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(against_lines({along_x(0, nan)}, {}, 0.1), std::invalid_argument);
  EXPECT_THROW(against_lines({}, {along_x(nan, 0)}, 0.1), std::invalid_argument);
  EXPECT_THROW(against_lines({}, {}, 0.0), std::invalid_argument);
}

TEST(MeasureAgainstLines, FindsTheSameNeighboursAsAFullSearch) {
  std::mt19937_64 rng(9);
  std::uniform_real_distribution<double> uniform(0.0, 60.0);
  std::vector<Segment3> lines;
  std::vector<Segment3> references;
  for (int i = 0; i < 1200; ++i) {
    const double x = uniform(rng);
    lines.push_back(along_x(x, x + 3.0, uniform(rng)));
    const double x_reference = uniform(rng);
    references.push_back(along_x(x_reference, x_reference + 3.0, uniform(rng)));
  }
  double expected_m = 0.0;
  for (const Segment3& r : references) {
    std::vector<ParameterInterval> parts;
    for (const Segment3& l : lines) {
      if (const auto part = part_near(r, l, 0.5)) parts.push_back(*part);
    }
    expected_m += 3.0 * total_length(join(std::move(parts)));
  }
  EXPECT_NEAR(*against_lines(lines, references, 0.5).completeness, expected_m / 3600.0, 1e-10);
}

TEST(MeasureAgainstPlanes, SolvesTheShareWithinTolerance) {
  LineEvaluation tilted = evaluated_line("a", 0.0, 1);  // from -0.1 m to 0.3 m
  tilted.planes[0].distance.start = -0.1;
  tilted.planes[0].distance.end = 0.3;
  tilted.planes[0].coverage = 0.8;
  const std::vector lines{tilted, excluded_line("b", Status::kNoPlane)};
  ToleranceOptions options;
  options.tolerances_m = {0.1, 0.5};
  const auto measures = measure_against_planes(lines, options);
  EXPECT_NEAR(*measures[0].precision, 0.8 * 0.5, kMeasureTol);
  EXPECT_NEAR(measures[0].limap_r_m, 2.5, kMeasureTol);
  EXPECT_NEAR(*measures[0].limap_p_percent, 100.0, kMeasureTol);
  EXPECT_NEAR(*measures[1].precision, 0.8, kMeasureTol);
  EXPECT_FALSE(measures[0].completeness);
}

TEST(MeasureAgainstPlanes, AsksARidgeToBeNearBothPlanes) {
  LineEvaluation ridge = evaluated_line("a", 0.05, 1);
  ridge.planes.push_back(ridge.planes[0]);
  ridge.planes[1].distance.start = 0.05;
  ridge.planes[1].distance.end = 0.25;
  ToleranceOptions options;
  options.tolerances_m = {0.15, 0.01};
  const auto measures = measure_against_planes(std::vector{ridge}, options);
  EXPECT_NEAR(*measures[0].precision, 0.5, kMeasureTol);
  EXPECT_EQ(*measures[1].precision, 0.0);
  EXPECT_EQ(*measures[1].limap_p_percent, 0.0);
}

TEST(TolerancesWithGsd, AddsMultiplesOfTheGroundSamplingDistance) {
  const std::vector<double> expected{0.05, 0.08, 0.10, 0.16, 0.25, 0.40, 0.50, 1.00};
  EXPECT_EQ(tolerances_with_gsd(0.08), expected);
  EXPECT_EQ(tolerances_with_gsd(0.1).size(), 6U) << "0.1 and 0.5 are there already";
  EXPECT_THROW(tolerances_with_gsd(0.0), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::evaluate
