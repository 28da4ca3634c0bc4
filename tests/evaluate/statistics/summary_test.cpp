// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/summary.h"

#include "evaluate/statistics/distribution.h"
#include "tests/evaluate/statistics/lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kSummaryTol = 1e-12;  // sums of a few numbers of order 1

TEST(Quantile, InterpolatesBetweenOrderStatisticsAsType7) {
  const std::vector<double> values{4.0, 1.0, 3.0, 2.0};
  EXPECT_NEAR(*quantile(values, 0.0), 1.0, kSummaryTol);
  EXPECT_NEAR(*quantile(values, 0.25), 1.75, kSummaryTol);
  EXPECT_NEAR(*quantile(values, 0.5), 2.5, kSummaryTol);
  EXPECT_NEAR(*quantile(values, 0.95), 3.85, kSummaryTol);
  EXPECT_NEAR(*quantile(values, 1.0), 4.0, kSummaryTol);
  EXPECT_NEAR(*quantile({7.0}, 0.3), 7.0, kSummaryTol);
  EXPECT_FALSE(quantile({}, 0.5));
  EXPECT_THROW(quantile(values, 1.1), std::invalid_argument);
  EXPECT_THROW(quantile(values, std::nan("")), std::invalid_argument);
}

TEST(Nmad, IsTheScaledMedianDeviationOfSignedValues) {
  // Median 1; deviations 3 1 0 1 9, their median 1.
  EXPECT_NEAR(*nmad(std::vector{-2.0, 0.0, 1.0, 2.0, 10.0}), 1.4826, kSummaryTol);
  EXPECT_NEAR(*nmad(std::vector{5.0}), 0.0, kSummaryTol);
  EXPECT_FALSE(nmad(std::vector<double>{}));
}

TEST(Nmad, EstimatesTheStandardDeviationOfNormalValues) {
  std::mt19937_64 rng(3);
  std::normal_distribution<double> normal(0.4, 2.0);
  std::vector<double> values(100'000);
  for (double& v : values) v = normal(rng);
  EXPECT_NEAR(*nmad(values), 2.0, 0.03);  // 4 sigma of an NMAD from 1e5 values
}

TEST(CompensatedSum, KeepsWhatPlainSummationLoses) {
  EXPECT_EQ(sum(std::vector{1e16, 1.0, 1.0, -1e16}), 2.0);
}

TEST(SummarizeClasses, HandCheckedCase) {
  const std::vector lines{evaluated_line("a", 0.3, 1), evaluated_line("b", -0.4, 1),
                          evaluated_line("c", 1.2, 2, "aligned"),
                          excluded_line("d", Status::kNoPlane, "aligned")};
  const std::vector<Summary> classes = summarize_classes(lines, {});
  ASSERT_EQ(classes.size(), 3U);
  const Summary& not_aligned = classes[0];
  EXPECT_EQ(not_aligned.line_class, "not_aligned");
  EXPECT_NEAR(*not_aligned.rms_m, std::sqrt(0.125), kSummaryTol);
  EXPECT_NEAR(*not_aligned.mean_m, -0.05, kSummaryTol);
  EXPECT_NEAR(*not_aligned.std_m, 0.35 * std::sqrt(2.0), kSummaryTol);
  EXPECT_NEAR(*not_aligned.median_m, 0.35, kSummaryTol);
  EXPECT_NEAR(*not_aligned.median_signed_m, -0.05, kSummaryTol);
  EXPECT_NEAR(*not_aligned.nmad_m, 1.4826 * 0.35, kSummaryTol);
  EXPECT_NEAR(*not_aligned.gross_share, 0.0, kSummaryTol);
  const Summary& aligned = classes[1];
  EXPECT_EQ(aligned.n_lines, 2U);
  EXPECT_EQ(aligned.n_evaluated, 1U);
  EXPECT_NEAR(*aligned.evaluated_share(), 0.5, kSummaryTol);
  EXPECT_NEAR(*aligned.evaluated_share_by_length(), 0.5, kSummaryTol);
  EXPECT_FALSE(aligned.std_m);
  EXPECT_FALSE(aligned.ci95_m) << "one cluster cannot be resampled";
  const Summary& total = classes[2];
  EXPECT_NEAR(*total.rms_m, std::sqrt(1.69 / 3.0), kSummaryTol);
  EXPECT_EQ(total.max_id, "c");
  EXPECT_NEAR(*total.max_m, 1.2, kSummaryTol);
  EXPECT_NEAR(*total.gross_share, 1.0 / 3.0, kSummaryTol);
  EXPECT_EQ(total.n_by_status[static_cast<std::size_t>(Status::kNoPlane)], 1U);
  EXPECT_EQ(total.n_clusters, 2U);
  EXPECT_TRUE(total.few_clusters());
  EXPECT_TRUE(total.ci95_m);
}

TEST(SummarizeClasses, GivesTotalAloneWhereNoLineIsClassed) {
  const std::vector lines{evaluated_line("a", 0.3, 1, "all"), evaluated_line("b", 0.1, 2, "eave")};
  const std::vector<Summary> classes = summarize_classes(lines, {});
  ASSERT_EQ(classes.size(), 1U);
  EXPECT_EQ(classes[0].line_class, "total");
  EXPECT_EQ(classes[0].n_evaluated, 2U);
}

TEST(SummarizeClasses, GivesAllClassesOfNoLines) {
  const std::vector<Summary> classes = summarize_classes({}, {});
  ASSERT_EQ(classes.size(), 3U);
  for (const char* line_class : {"not_aligned", "aligned", "total"}) {
    ASSERT_NE(find_class(classes, line_class), nullptr) << line_class;
    EXPECT_EQ(find_class(classes, line_class)->n_lines, 0U);
  }
}

TEST(SummarizeClasses, CountsLinesOfAnotherClassInTheTotal) {
  const std::vector lines{evaluated_line("a", 0.3, 1, "aligned"),
                          evaluated_line("b", 0.1, 2, "eave")};
  const std::vector<Summary> classes = summarize_classes(lines, {});
  EXPECT_EQ(find_class(classes, kAligned)->n_lines, 1U);
  EXPECT_EQ(find_class(classes, kNotAligned)->n_lines, 0U);
  EXPECT_EQ(find_class(classes, kTotal)->n_lines, 2U);
  EXPECT_EQ(find_class(classes, "eave"), nullptr);
}

TEST(SummarizeClasses, HasNoFiguresWithoutEvaluatedLines) {
  const std::vector<Summary> classes =
      summarize_classes(std::vector{excluded_line("d", Status::kNoLidar)}, {});
  const Summary& total = classes.back();
  EXPECT_EQ(total.n_lines, 1U);
  EXPECT_FALSE(total.rms_m || total.mean_m || total.median_m || total.nmad_m || total.q95_m ||
               total.max_m || total.gross_share || total.ci95_m || total.rms_length_weighted_m);
}

TEST(SummarizeClasses, WeighsTheSecondRmsByLength) {
  std::vector lines{evaluated_line("a", 0.3, 1), evaluated_line("b", 0.1, 1)};
  lines[0].length_m = 1.0;
  lines[1].length_m = 3.0;
  EXPECT_NEAR(*summarize_classes(lines, {}).back().rms_length_weighted_m,
              std::sqrt((0.09 + 0.03) / 4.0), kSummaryTol);
}

TEST(SummarizeClasses, CountsOutliersOnceAndKeepsThemInTheHeadline) {
  std::vector<LineEvaluation> lines;
  for (int i = 0; i < 99; ++i) lines.push_back(evaluated_line(std::to_string(i), 0.1, i));
  lines.push_back(evaluated_line("far", 10.0, 99));
  const Summary total = summarize_classes(lines, {}).back();
  EXPECT_EQ(total.n_outliers, 1U);
  EXPECT_NEAR(*total.rms_m, std::sqrt((0.99 + 100.0) / 100.0), kSummaryTol);
  EXPECT_NEAR(*total.rms_without_outliers_m, 0.1, kSummaryTol);
  SummaryOptions options;
  options.outlier_limit_m = 20.0;
  EXPECT_EQ(summarize_classes(lines, options).back().n_outliers, 0U);
}

/// The total of lines that lie so far off.
Summary total_of(const std::vector<double>& distances_m) {
  std::vector<LineEvaluation> lines;
  for (const double d : distances_m) lines.push_back(evaluated_line("a", d, lines.size() + 1));
  return summarize_classes(lines, {}).back();
}

TEST(SummarizeClasses, CountsTheLinesThatMakeHalfOfTheSquares) {
  const Summary one_bad = total_of({-1.0, 4.0, 2.0, -2.0});  // squares 1, 16, 4, 4; half is 12.5
  EXPECT_EQ(one_bad.n_half_of_squares, 1U);
  EXPECT_NEAR(*one_bad.rms_without_half_m, std::sqrt(3.0), kSummaryTol);
  const Summary equal = total_of(std::vector(10, -0.5));
  EXPECT_EQ(equal.n_half_of_squares, 5U);
  EXPECT_NEAR(*equal.rms_without_half_m, 0.5, kSummaryTol);
  EXPECT_EQ(total_of({0.0, 0.0}).n_half_of_squares, 0U);
  EXPECT_FALSE(total_of({0.3}).rms_without_half_m) << "no other line is left";
}

LineEvaluation decided_line(std::string id,
                            double distance_m,
                            std::optional<DecidedBy> decided_by) {
  LineEvaluation line = evaluated_line(std::move(id), distance_m, 1, "aligned");
  line.building = line.id;
  line.decided_by = decided_by;
  return line;
}

TEST(SummarizeClasses, PartsLinesByWhatDecidedOnTheirSurface) {
  std::vector<LineEvaluation> lines{decided_line("a", 0.3, DecidedBy::kPlan),
                                    decided_line("b", -0.4, DecidedBy::kImages),
                                    decided_line("c", 0.5, {}),
                                    decided_line("d", 2.0, DecidedBy::kPoints),
                                    decided_line("e", 4.0, DecidedBy::kPlace),
                                    excluded_line("f", Status::kNoPlane, "aligned")};
  lines[4].displacement = RidgeDisplacement{.horizontal_m = 4.0, .vertical_m = 3.0};
  const std::vector<Summary> classes = summarize_classes(lines, {});
  for (const Summary& s : {classes[1], classes[2]}) {
    ASSERT_EQ(s.by_group.size(), 2U) << s.line_class;
    const Summary headline = s.of_group(DecidedGroup::kPlanImages);
    EXPECT_NEAR(*headline.rms_m, std::sqrt(0.5 / 3.0), kSummaryTol);
    EXPECT_EQ(headline.n_evaluated, 3U)
        << "a line without an entry counts as decided by plan and images";
    EXPECT_EQ(headline.n_lines, 6U);
    EXPECT_NEAR(*headline.evaluated_share_by_length(), 0.5, kSummaryTol);
    EXPECT_EQ(headline.n_parts, 0U);
    EXPECT_EQ(headline.n_clusters, 3U);
    const Summary of_place = s.of_group(DecidedGroup::kPointsPlace);
    EXPECT_NEAR(*of_place.rms_m, std::sqrt(10.0), kSummaryTol);
    EXPECT_EQ(of_place.n_parts, 1U);
    EXPECT_NEAR(*s.rms_m, std::sqrt(20.5 / 5.0), kSummaryTol);
    EXPECT_EQ(s.max_id, "e");
  }
  EXPECT_TRUE(classes[0].by_group.empty());
}

TEST(SummarizeClasses, HasNoGroupsWherePlanAndImagesDecidedOnAll) {
  const Summary total =
      summarize_classes(
          std::vector{decided_line("a", 0.3, DecidedBy::kPlan), decided_line("b", 0.1, {})}, {})
          .back();
  EXPECT_TRUE(total.by_group.empty());
  EXPECT_EQ(total.of_group(DecidedGroup::kPlanImages).rms_m, total.rms_m);
  const Summary none = total.of_group(DecidedGroup::kPointsPlace);
  EXPECT_EQ(none.n_evaluated, 0U);
  EXPECT_EQ(none.n_lines, 2U);
  EXPECT_FALSE(none.rms_m);
}

TEST(AssertGroupsPooled, ThrowsWhereTheGroupsDoNotAddUp) {
  const Summary right = summarize_classes(std::vector{decided_line("a", 0.3, DecidedBy::kPlan),
                                                      decided_line("b", 0.1, DecidedBy::kPlace)},
                                          {})
                            .back();
  EXPECT_NO_THROW(assert_groups_pooled(right));
  Summary wrong = right;
  wrong.by_group[1].sum_squares_m2 *= 1.0 + 1e-10;
  EXPECT_THROW(assert_groups_pooled(wrong), std::logic_error);
  wrong = right;
  ++wrong.by_group[0].n_evaluated;
  EXPECT_THROW(assert_groups_pooled(wrong), std::logic_error);
}

TEST(SummarizeClasses, SatisfiesItsIdentitiesOnRandomLines) {
  std::mt19937_64 rng(5);
  std::normal_distribution<double> normal(0.05, 0.2);
  SummaryOptions options;
  options.bootstrap.replicates = 20;
  for (int trial = 0; trial < 200; ++trial) {
    SCOPED_TRACE(trial);
    std::vector<LineEvaluation> lines;
    for (int i = 0; i < 30; ++i) {
      lines.push_back(evaluated_line(std::to_string(i), normal(rng), rng() % 7,
                                     rng() % 3 == 0 ? "aligned" : "not_aligned"));
    }
    const std::vector<Summary> classes = summarize_classes(lines, options);
    double squares = 0.0;
    for (const Summary& s : {classes[0], classes[1]}) {
      if (s.n_evaluated > 0) squares += static_cast<double>(s.n_evaluated) * *s.rms_m * *s.rms_m;
    }
    const Summary& total = classes[2];
    const double n = 30.0;
    EXPECT_NEAR(squares, n * *total.rms_m * *total.rms_m, kSummaryTol);
    EXPECT_NEAR(*total.rms_signed_m * *total.rms_signed_m,
                *total.mean_m * *total.mean_m + *total.std_m * *total.std_m * (n - 1.0) / n,
                kSummaryTol);
  }
}

TEST(SummarizeClasses, ReportsANonFiniteDistanceAsADefect) {
  const std::vector lines{evaluated_line("a", std::numeric_limits<double>::quiet_NaN(), 1)};
  EXPECT_THROW(summarize_classes(lines, {}), std::logic_error);
}

TEST(AssertPooled, ThrowsWhereThePartsDoNotAddUp) {
  const std::vector lines{evaluated_line("a", 0.3, 1), evaluated_line("c", 1.2, 2, "aligned")};
  std::vector<Summary> classes = summarize_classes(lines, {});
  const std::vector parts{classes[0], classes[1]};
  EXPECT_NO_THROW(assert_pooled(classes[2], parts));
  Summary total = classes[2];
  total.sum_squares_m2 *= 1.0 + 1e-11;
  EXPECT_THROW(assert_pooled(total, parts), std::logic_error);
  total = classes[2];
  ++total.n_evaluated;
  EXPECT_THROW(assert_pooled(total, parts), std::logic_error);
  total = classes[2];
  ++total.n_by_status[static_cast<std::size_t>(Status::kAmbiguous)];
  EXPECT_THROW(assert_pooled(total, parts), std::logic_error);
  EXPECT_THROW(assert_pooled(classes[2], std::vector{classes[0]}), std::logic_error);
}

/// Share of aligned lines that a published total implies: total^2 = (1 - f) not^2 + f aligned^2.
double implied_aligned_share(double not_aligned_m, double aligned_m, double total_m) {
  return (total_m * total_m - not_aligned_m * not_aligned_m) /
         (aligned_m * aligned_m - not_aligned_m * not_aligned_m);
}

TEST(PooledIdentity, ShowsThatThePublishedTotalsBelongToDifferentLineSets) {
  EXPECT_NEAR(implied_aligned_share(0.152, 1.041, 0.495), 0.209, 5e-4);
  EXPECT_NEAR(implied_aligned_share(0.152, 0.357, 0.204), 0.177, 5e-4);
  EXPECT_NEAR(implied_aligned_share(0.173, 4.451, 2.240), 0.252, 5e-4);
  EXPECT_NEAR(implied_aligned_share(0.173, 0.196, 0.179), 0.249, 5e-4);
  EXPECT_NEAR(implied_aligned_share(0.194, 6.278, 3.768), 0.360, 5e-4);
  EXPECT_NEAR(implied_aligned_share(0.194, 0.459, 0.275), 0.220, 5e-4);
}

}  // namespace
}  // namespace ridgeline::evaluate
