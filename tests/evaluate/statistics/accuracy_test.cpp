// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/accuracy.h"

#include "evaluate/statistics/calibration.h"
#include "evaluate/statistics/frame_check.h"
#include "evaluate/statistics/strata.h"
#include "tests/evaluate/statistics/lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kAccuracyTol = 1e-12;

TEST(AccuracyNumbers, AddAndRemoveTheReferencesError) {
  const AccuracyNumbers numbers = accuracy_numbers(0.152, 0.034);
  EXPECT_NEAR(*numbers.product_m, 0.156, 5e-4);
  EXPECT_NEAR(*numbers.method_only_m, 0.148, 5e-4);
  EXPECT_FALSE(numbers.below_reference_noise);
}

TEST(AccuracyNumbers, SayWhenTheMethodIsBelowTheReferencesNoise) {
  const AccuracyNumbers numbers = accuracy_numbers(0.03, 0.034);
  EXPECT_FALSE(numbers.method_only_m);
  EXPECT_TRUE(numbers.below_reference_noise);
  EXPECT_EQ(*accuracy_numbers(0.034, 0.034).method_only_m, 0.0);
  EXPECT_FALSE(accuracy_numbers(std::nullopt, 0.034).product_m);
  EXPECT_THROW(accuracy_numbers(0.1, -0.1), std::invalid_argument);
  EXPECT_THROW(accuracy_numbers(-0.1, 0.1), std::invalid_argument);
}

Evaluation many_lines(int n, double mean_m, double spread_m) {
  Evaluation e;
  for (int i = 0; i < n; ++i) {
    e.lines.push_back(evaluated_line(std::to_string(i), mean_m + (i % 2 == 0 ? 1 : -1) * spread_m,
                                     static_cast<std::uint64_t>(i + 1)));
  }
  return with_summaries(std::move(e));
}

TEST(AccuracyStatements, CombineSystematicAndRandomPartOfTheReference) {
  Evaluation e = many_lines(40, 0.0, 0.1);
  for (LineEvaluation& line : e.lines) line.sigma_plane_m = 0.03;
  e.options.sigma_sys_m = 0.04;
  const AccuracyStatement total = accuracy_statements(e).back();
  EXPECT_NEAR(total.numbers.sigma_ref_m, 0.05, kAccuracyTol);
  EXPECT_EQ(total.n, 40U);
  EXPECT_TRUE(total.flags().empty());
}

TEST(AccuracyStatements, FlagBiasSmallSamplesAndExtrapolation) {
  // mean 0.3 of spread 1: 0.3 / sqrt(1.09) = 0.287 of the RMS; 0.2 / sqrt(1.04) = 0.196
  EXPECT_THAT(accuracy_statements(many_lines(40, 0.3, 1.0)).back().flags(), ElementsAre("bias"));
  EXPECT_TRUE(accuracy_statements(many_lines(40, 0.2, 1.0)).back().flags().empty());
  EXPECT_THAT(accuracy_statements(many_lines(28, 0.0, 1.0)).back().flags(),
              ElementsAre("n_below_30"));
  EXPECT_THAT(accuracy_statements(many_lines(8, 0.0, 1.0)).back().flags(),
              ElementsAre("n_below_30", "few_clusters"));
  Evaluation e = many_lines(40, 0.0, 1.0);
  e.lines[0].planes[0].extrapolation_m = e.lines[1].planes[0].extrapolation_m = 0.6;
  EXPECT_TRUE(accuracy_statements(e).back().flags().empty()) << "5 % of the lines";
  e.lines[2].planes[0].extrapolation_m = 0.6;
  EXPECT_THAT(accuracy_statements(e).back().flags(), ElementsAre("extrapolation"));
}

std::vector<std::size_t> all_of(const std::vector<LineEvaluation>& lines) {
  std::vector<std::size_t> members(lines.size());
  std::iota(members.begin(), members.end(), std::size_t{0});
  return members;
}

TEST(Calibrate, HandCheckedCase) {
  std::vector lines{evaluated_line("a", 0.1, 1), evaluated_line("b", -0.3, 2),
                    evaluated_line("c", 9.0, 3), excluded_line("d", Status::kNoPlane)};
  lines[0].sigma_line_m = 0.06;
  lines[0].sigma_plane_m = 0.08;  // z = 1
  lines[1].sigma_line_m = 0.1;    // z = -3
  lines[3].sigma_line_m = 0.1;
  const Calibration c = calibrate(lines, all_of(lines), "total", 0.0);
  EXPECT_EQ(c.n, 2U) << "c has no predicted sigma, d no distance";
  EXPECT_NEAR(*c.nees_per_dof, 5.0, kAccuracyTol);
  EXPECT_NEAR(*c.median_z2, 5.0, kAccuracyTol);
  EXPECT_NEAR(*c.coverage_1_96, 0.5, kAccuracyTol);
  EXPECT_EQ(*c.share_beyond_99_9, 0.0) << "z = -3 is within 3.29";
  EXPECT_NEAR(*c.median_sigma_m, 0.1, kAccuracyTol);
  EXPECT_TRUE(c.optimistic());
  EXPECT_NEAR(*calibrate(lines, all_of(lines), "", std::sqrt(0.03)).nees_per_dof, 1.25,
              kAccuracyTol);
}

TEST(Calibrate, FindsRightSigmasRight) {
  std::mt19937_64 rng(8);
  std::vector<LineEvaluation> lines;
  for (int i = 0; i < 4000; ++i) {
    const double sigma = 0.05 + 0.01 * (i % 10);
    std::normal_distribution<double> normal(0.0, sigma);
    lines.push_back(evaluated_line(std::to_string(i), normal(rng), 1));
    lines.back().sigma_line_m = sigma;
  }
  const Calibration c = calibrate(lines, all_of(lines), "total", 0.0);
  EXPECT_NEAR(*c.nees_per_dof, 1.0, 4.0 * std::sqrt(2.0 / 4000.0));  // 4 sigma
  EXPECT_NEAR(*c.median_z2, 0.455, 0.05);
  EXPECT_NEAR(*c.coverage_1_96, 0.95, 4.0 * std::sqrt(0.95 * 0.05 / 4000.0));
  EXPECT_NEAR(*c.share_beyond_99_9, 0.001, 4.0 * std::sqrt(0.001 / 4000.0));
  for (LineEvaluation& line : lines) *line.sigma_line_m *= 2.0;
  EXPECT_TRUE(calibrate(lines, all_of(lines), "total", 0.0).pessimistic());
}

TEST(Calibrate, HasNoFigureWithoutCovariance) {
  const std::vector lines{evaluated_line("a", 0.1, 1)};
  const Calibration c = calibrate(lines, all_of(lines), "total", 0.0);
  EXPECT_FALSE(c.nees_per_dof || c.bounds95 || c.coverage_1_96);
  EXPECT_FALSE(c.optimistic() || c.pessimistic());
}

const Stratification& by(const std::vector<Stratification>& all, const std::string& property) {
  for (const Stratification& s : all) {
    if (s.by == property) return s;
  }
  throw std::logic_error("no stratification by " + property);
}

std::size_t n_in(const Stratification& s, const std::string& label) {
  for (const Stratum& stratum : s.strata) {
    if (stratum.summary.line_class == label) return stratum.summary.n_lines;
  }
  throw std::logic_error("no stratum " + label);
}

TEST(Stratify, IncludesTheUpperBoundOfEachBin) {
  Evaluation e;
  for (const double angle_deg : {0.0, 2.0, 2.001, 5.0, 10.0, 10.001, 90.0}) {
    e.lines.push_back(evaluated_line(std::to_string(angle_deg), 0.1, 1));
    e.lines.back().epipolar_angle_deg = angle_deg;
  }
  e.lines.push_back(evaluated_line("none", 0.1, 1));
  const std::vector<Stratification> all = stratify(e);
  const Stratification& angle = by(all, "epipolar_angle_deg");
  EXPECT_EQ(n_in(angle, "0-2"), 2U);
  EXPECT_EQ(n_in(angle, "2-5"), 2U);
  EXPECT_EQ(n_in(angle, "5-10"), 1U);
  EXPECT_EQ(n_in(angle, "10-20"), 1U);
  EXPECT_EQ(n_in(angle, "20-45"), 0U);
  EXPECT_EQ(n_in(angle, "45-90"), 1U);
  EXPECT_EQ(n_in(angle, "unknown"), 1U);
}

TEST(Stratify, SeparatesNumbersOfImagesIfALineHasThree) {
  Evaluation e;
  for (const int n_images : {2, 3, 3, 4, 5, 9}) {
    e.lines.push_back(evaluated_line(std::to_string(e.lines.size()), 0.1, 1));
    e.lines.back().n_images = n_images;
  }
  e.lines.push_back(evaluated_line("none", 0.1, 1));
  const std::vector<Stratification> all = stratify(e);
  const Stratification& images = by(all, "n_images");
  EXPECT_EQ(n_in(images, "2"), 1U);
  EXPECT_EQ(n_in(images, "3"), 2U);
  EXPECT_EQ(n_in(images, "4"), 1U);
  EXPECT_EQ(n_in(images, "5 and more"), 2U);
  EXPECT_EQ(n_in(images, "unknown"), 1U);
  std::erase_if(e.lines, [](const LineEvaluation& line) { return line.n_images.value_or(2) > 2; });
  EXPECT_THROW((void)by(stratify(e), "n_images"), std::logic_error);
}

TEST(Stratify, SeparatesKindsLengthsSlopesAndPredictedSigmas) {
  Evaluation e;
  for (int i = 0; i < 8; ++i) {
    e.lines.push_back(evaluated_line(std::to_string(i), 0.1, 1));
    e.lines.back().sigma_line_m = 0.01 * (i + 1);
  }
  e.lines[0].kind = Kind::kRidge;
  e.lines[1].length_m = 60.0;
  e.lines[2].planes[0].plane = Plane3(Eigen::Vector3d(0.6, 0.0, 0.8), 0.0);  // 36.9 degrees
  e.lines.push_back(excluded_line("x", Status::kNoLidar));
  const std::vector<Stratification> all = stratify(e);
  EXPECT_EQ(n_in(by(all, "kind"), "ridge"), 1U);
  EXPECT_EQ(n_in(by(all, "kind"), "step"), 7U);
  EXPECT_EQ(n_in(by(all, "kind"), "unknown"), 1U);
  EXPECT_EQ(n_in(by(all, "length_m"), "> 20"), 1U);
  EXPECT_EQ(n_in(by(all, "length_m"), "2-5"), 8U);
  EXPECT_EQ(n_in(by(all, "roof_slope_deg"), "35-50"), 1U);
  for (const char* quartile : {"1", "2", "3", "4"}) {
    EXPECT_EQ(n_in(by(all, "sigma_line_quartile"), quartile), 2U) << quartile;
  }
}

TEST(CheckFrame, TellsLinesThatLieElsewhere) {
  std::vector<LineEvaluation> lines(30, excluded_line("", Status::kNoLidar));
  lines[0] = evaluated_line("a", 0.1, 1);
  const FrameCheck elsewhere = check_frame(lines, 1.0);
  EXPECT_FALSE(elsewhere.same_frame);
  EXPECT_THAT(elsewhere.reason, HasSubstr("only 1 of 30 lines are near the cloud"));
  lines[1] = evaluated_line("b", 0.1, 1);
  EXPECT_TRUE(check_frame(lines, 1.0).same_frame) << "2 of 30 is above 5 %";
}

TEST(CheckFrame, TakesLinesOutOfRangeForLinesElsewhere) {
  const std::vector<LineEvaluation> lines(3, excluded_line("", Status::kOutOfRange));
  EXPECT_THAT(check_frame(lines, 1.0).reason, HasSubstr("only 0 of 3 lines are near the cloud"));
  std::vector<LineEvaluation> without_height = lines;  // two of them
  without_height[1].length_m = 0.0;                    // the line has no place on Earth
  EXPECT_THAT(check_frame(without_height, 1.0).reason,
              HasSubstr("(2 have the same height more than 100 m above or below it)"));
}

TEST(CheckFrame, TellsLinesAtAnotherHeight) {
  const std::vector lines{evaluated_line("a", 45.0, 1), evaluated_line("b", 47.0, 2)};
  EXPECT_FALSE(check_frame(lines, 1.0).same_frame);
  EXPECT_THAT(check_frame(lines, 1.0).reason, HasSubstr("median distance of the lines is 46.0 m"));
  EXPECT_TRUE(check_frame(lines, 2.3).same_frame) << "exactly 20 tolerances";
}

TEST(CheckFrame, JudgesOnlyLinesWithAGeometry) {
  std::vector<LineEvaluation> lines(30, excluded_line("", Status::kNotReconstructed));
  EXPECT_TRUE(check_frame(lines, 1.0).same_frame);
  EXPECT_FALSE(check_frame(lines, 1.0).near_share);
  lines.push_back(evaluated_line("a", 0.1, 1));
  EXPECT_EQ(*check_frame(lines, 1.0).near_share, 1.0);
  EXPECT_THROW(check_frame(lines, 0.0), std::invalid_argument);
}

TEST(OnCommonLines, KeepsWhatEveryMethodSolved) {
  Evaluation a = many_lines(3, 0.0, 0.1);
  Evaluation b = a;
  b.lines[1] = excluded_line("1", Status::kNoPlane);
  const std::vector<Evaluation> common = on_common_lines(std::vector{a, b});
  ASSERT_EQ(common.size(), 2U);
  for (const Evaluation& e : common) {
    EXPECT_EQ(e.lines.size(), 2U);
    EXPECT_EQ(e.classes.back().n_evaluated, 2U);
  }
  b.patch = "other";
  EXPECT_THROW(on_common_lines(std::vector{a, b}), std::invalid_argument);
  EXPECT_TRUE(on_common_lines({}).empty());
}

}  // namespace
}  // namespace ridgeline::evaluate
