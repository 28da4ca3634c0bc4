// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/compare/comparison.h"

#include "evaluate/compare/pair_in_space.h"
#include "evaluate/compare/wilcoxon.h"
#include "tests/evaluate/statistics/lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr double kComparisonTol = 1e-12;

TEST(Wilcoxon, IsExactForFewDifferences) {
  // All five positive: 2 of the 32 sign patterns are as extreme.
  EXPECT_NEAR(*wilcoxon_signed_rank_p(std::vector{1.0, 2.0, 3.0, 4.0, 5.0}), 2.0 / 32.0,
              kComparisonTol);
  // W+ = 1 + 2 = 3: rank sums 0, 1, 2, 3 (twice) in each tail of 16.
  EXPECT_NEAR(*wilcoxon_signed_rank_p(std::vector{1.0, 2.0, -3.0, -4.0}), 10.0 / 16.0,
              kComparisonTol);
  // Two ties of mean rank 1.5 and one rank 3: sums 0, 1.5, 1.5, 3, 3, 4.5, 4.5, 6; W+ = 1.5.
  EXPECT_NEAR(*wilcoxon_signed_rank_p(std::vector{1.0, -1.0, -2.0, 0.0}), 6.0 / 8.0,
              kComparisonTol);
}

TEST(Wilcoxon, HasNoAnswerWithoutDifference) {
  EXPECT_FALSE(wilcoxon_signed_rank_p(std::vector{0.0, 0.0}));
  EXPECT_FALSE(wilcoxon_signed_rank_p(std::vector<double>{}));
  EXPECT_THROW(wilcoxon_signed_rank_p(std::vector{std::nan("")}), std::invalid_argument);
}

TEST(Wilcoxon, IgnoresTheOrderAndTheSignOfAll) {
  std::vector<double> d{0.3, -0.1, 0.7, 0.2, -0.4, 0.9};
  const double p = *wilcoxon_signed_rank_p(d);
  std::reverse(d.begin(), d.end());
  EXPECT_EQ(*wilcoxon_signed_rank_p(d), p);
  for (double& v : d) v = -v;
  EXPECT_NEAR(*wilcoxon_signed_rank_p(d), p, kComparisonTol);
}

TEST(Wilcoxon, ApproximationRejectsATrueHypothesisAsOftenAsStated) {
  std::mt19937_64 rng(11);
  std::normal_distribution<double> normal;
  constexpr int kTrials = 2000;
  for (const std::size_t n : {std::size_t{20}, std::size_t{40}}) {  // exact and approximate test
    int n_rejected = 0;
    std::vector<double> d(n);
    for (int trial = 0; trial < kTrials; ++trial) {
      for (double& v : d) v = normal(rng);
      if (*wilcoxon_signed_rank_p(d) < 0.05) ++n_rejected;
    }
    // 4 sigma of a binomial proportion of 0.05; the test is slightly conservative (discrete)
    EXPECT_NEAR(n_rejected / double{kTrials}, 0.048, 0.02) << n;
  }
}

Evaluation evaluation_of(const std::string& method, std::vector<LineEvaluation> lines) {
  Evaluation e;
  e.patch = "1";
  e.method = method;
  e.lines = std::move(lines);
  return with_summaries(std::move(e));
}

Evaluation evaluation_a() {
  return evaluation_of(
      "direct", {evaluated_line("n1", 0.1, 1), evaluated_line("a1", 0.8, 1, "aligned"),
                 evaluated_line("a2", -0.6, 2, "aligned"), evaluated_line("only_a", 9.0, 3)});
}

Evaluation evaluation_b() {
  return evaluation_of(
      "joint", {evaluated_line("a2", 0.7, 2, "aligned"), evaluated_line("a1", 0.2, 1, "aligned"),
                evaluated_line("n1", 0.1, 1), excluded_line("only_a", Status::kNoPlane)});
}

TEST(Compare, PairsByLineIdOnTheCommonSet) {
  const Comparison c = compare(evaluation_a(), evaluation_b(), "A", "B");
  EXPECT_EQ(c.n_common, 3U);
  EXPECT_EQ(c.n_only_a, 1U);
  EXPECT_EQ(c.n_only_b, 0U);
  ASSERT_EQ(c.classes.size(), 3U);
  const PairedSummary& aligned = c.classes[1];
  EXPECT_EQ(aligned.n, 2U);
  EXPECT_NEAR(*aligned.rms_a_m, std::sqrt(0.5), kComparisonTol);
  EXPECT_NEAR(*aligned.rms_b_m, std::sqrt(0.265), kComparisonTol);
  EXPECT_NEAR(*aligned.rms_ratio, std::sqrt(0.53), kComparisonTol);
  EXPECT_NEAR(*aligned.rms_gain_m, std::sqrt(0.5) - std::sqrt(0.265), kComparisonTol);
  EXPECT_NEAR(*aligned.median_gain_m, 0.25, kComparisonTol);
  EXPECT_EQ(aligned.n_clusters, 2U);
  ASSERT_TRUE(aligned.rms_ratio_ci95);
  EXPECT_NEAR(aligned.rms_ratio_ci95->low, 0.25, kComparisonTol) << "a1 drawn twice";
  EXPECT_NEAR(aligned.rms_ratio_ci95->high, 0.7 / 0.6, kComparisonTol) << "a2 drawn twice";
  const PairedSummary& total = c.classes[2];
  EXPECT_EQ(total.n_improved, 1U);
  EXPECT_EQ(total.n_unchanged, 1U);
  EXPECT_EQ(total.n_worse, 1U);
  ASSERT_EQ(c.worst.size(), 1U);
  EXPECT_EQ(c.worst[0].id, "a2");
  EXPECT_EQ(find_class(c.own_a, kTotal)->n_evaluated, 4U);
  EXPECT_EQ(find_class(c.own_b, kTotal)->n_evaluated, 3U);
}

TEST(Compare, FlagsNotAlignedLinesThatDirectAndJointSolveDifferently) {
  EXPECT_EQ(compare(evaluation_a(), evaluation_b(), "", "").n_not_aligned_differing, 1U);
  Evaluation same = evaluation_a();
  same.method = "joint";
  EXPECT_EQ(compare(evaluation_a(), same, "", "").n_not_aligned_differing, 0U);
  same.method = "network";
  EXPECT_FALSE(compare(evaluation_a(), same, "", "").n_not_aligned_differing);
}

TEST(Compare, LeavesLinesThatNoEdgeShowsOutOfPairsById) {
  const Evaluation a =
      evaluation_of("lines", {evaluated_line("1", 0.1, 1), evaluated_line("p0", 0.2, 2)});
  const Evaluation b =
      evaluation_of("lines", {evaluated_line("1", 0.1, 1), evaluated_line("p0", 0.9, 3)});
  const Comparison c = compare(a, b, "A", "B");
  EXPECT_EQ(c.n_common, 1U);
  EXPECT_EQ(c.n_only_a + c.n_only_b, 0U);
  EXPECT_EQ(c.own_b.back().n_evaluated, 2U);  // the figures of each run are of all its lines
}

TEST(Compare, HasNoFiguresWithoutCommonLines) {
  const Comparison c = compare(evaluation_a(), evaluation_of("x", {}), "A", "B");
  EXPECT_EQ(c.n_common, 0U);
  EXPECT_FALSE(c.classes.back().rms_ratio || c.classes.back().wilcoxon_p);
}

TEST(Compare, TakesAPerfectAWithoutARatio) {
  const Evaluation zero = evaluation_of("x", {evaluated_line("a1", 0.0, 1)});
  const Comparison c = compare(zero, evaluation_b(), "A", "B");
  EXPECT_FALSE(c.classes.back().rms_ratio);
  EXPECT_NEAR(*c.classes.back().rms_gain_m, -0.2, kComparisonTol);
}

/// A line of the given id along x at y, 5 m long unless said otherwise.
LineEvaluation placed_line(const std::string& id,
                           double y_m,
                           double distance_m,
                           const std::string& class_base = "",
                           double length_m = 5.0) {
  LineEvaluation line = evaluated_line(id, distance_m, 1, "not_aligned");
  line.segment = Segment3{{0.0, y_m, 0.0}, {length_m, y_m, 0.0}};
  line.class_base = class_base;
  return line;
}

TEST(PairInSpace, TakesTheClosestOfThoseThatRunAlong) {
  const std::vector<Segment3> a{
      {{0, 0, 0}, {5, 0, 0}}, {{0, 9, 0}, {5, 9, 0}}, {{0, 20, 0}, {5, 20, 0}}};
  const std::vector<Segment3> b{{{0, 0.3, 0}, {5, 0.3, 0}},    // farther than the next one
                                {{5, 0.1, 0}, {0, 0.1, 0}},    // the other way round
                                {{0, 9, 0}, {5, 10, 0}},       // 11 degrees
                                {{0, 10.1, 0}, {5, 10.1, 0}},  // 1.1 m
                                {{4, 20, 0}, {9, 20, 0}}};     // 1 of 5 m beside
  EXPECT_THAT(pair_in_space(a, b), testing::ElementsAre(testing::Pair(0, 1)));
  EXPECT_THAT(pair_in_space(b, a), testing::ElementsAre(testing::Pair(1, 0)));
}

TEST(PairInSpace, MakesTheSumOfDistancesTheSmallest) {
  // the closest two, 0.5 m apart, would leave the others without a partner
  const std::vector<Segment3> a{{{0, 0, 0}, {5, 0, 0}}, {{0, 1.2, 0}, {5, 1.2, 0}}};
  const std::vector<Segment3> b{{{0, 0.5, 0}, {5, 0.5, 0}}, {{0, -0.6, 0}, {5, -0.6, 0}}};
  EXPECT_THAT(pair_in_space(a, b), testing::ElementsAre(testing::Pair(0, 1), testing::Pair(1, 0)));
  EXPECT_THAT(pair_in_space(b, a), testing::ElementsAre(testing::Pair(0, 1), testing::Pair(1, 0)));
}

TEST(PairInSpace, IsTheBestOfAllAssignmentsOfSmallSets) {
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> place(0.0, 2.0);
  const auto at = [&] {
    const double y = place(rng);
    return Segment3{{0, y, 0}, {5, y, 0}};
  };
  const auto cost_of = [](const Segment3& s, const Segment3& t) {
    return std::abs(s.start.y() - t.start.y());
  };
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<Segment3> a{at(), at(), at()}, b{at(), at(), at(), at()};
    double sum_m = 3.0 * kMaxPairDistance_m;
    for (const auto& [i, k] : pair_in_space(a, b))
      sum_m += cost_of(a[i], b[k]) - kMaxPairDistance_m;
    std::vector<std::size_t> order{0, 1, 2, 3};
    double least_m = HUGE_VAL;
    do {
      double of_order_m = 0.0;
      for (std::size_t i = 0; i < a.size(); ++i)
        of_order_m += std::min(kMaxPairDistance_m, cost_of(a[i], b[order[i]]));
      least_m = std::min(least_m, of_order_m);
    } while (std::ranges::next_permutation(order).found);
    EXPECT_NEAR(sum_m, least_m, kComparisonTol) << trial;
  }
}

TEST(CompareFolders, PairsRunsOfDifferentNumbersOfViewsInSpaceByTheClassOfTheBasePair) {
  ResultFolder two;
  two.name = "two";
  two.evaluations = {
      evaluation_of("joint", {placed_line("0", 0.0, 0.4), placed_line("1", 9.0, 0.2)})};
  two.evaluations[0].lines[0].line_class = "aligned";
  two.n_views = {{"1", 2}};
  ResultFolder five = two;
  five.name = "five";
  five.n_views = {{"1", 5}};
  five.evaluations = {evaluation_of(
      "joint", {placed_line("0", 9.1, 0.1, "not_aligned"), placed_line("1", 0.1, 0.1, "aligned"),
                placed_line("2", 30.0, 0.1, "aligned")})};
  five.evaluations[0].origin_m = {0.0, 0.0, 0.5};
  const ComparisonReport report = compare_folders(std::vector{two, five});
  const Comparison& c = report.comparisons.at(0);
  EXPECT_EQ(c.n_common, 2U);
  EXPECT_EQ(c.n_only_b, 1U);
  ASSERT_EQ(c.classes.size(), 3U);
  EXPECT_EQ(c.classes[1].n, 1U) << "aligned by the base pair";
  EXPECT_DOUBLE_EQ(*c.classes[1].rms_a_m, 0.4);
  EXPECT_EQ(find_class(c.own_b, kAligned)->n_lines, 2U);
  EXPECT_FALSE(c.n_not_aligned_differing);
  EXPECT_THAT(to_terminal(report), HasSubstr("A used 2 images, B used 5"));
  EXPECT_THAT(report.warnings, testing::IsEmpty());
}

TEST(CompareFolders, PairsByIdsWhereBothHaveTheSameSegmentsAndMatches) {
  ResultFolder a;
  a.evaluations = {
      evaluation_of("joint", {placed_line("0", 0.0, 0.4), placed_line("1", 9.0, 0.2)})};
  a.id_hashes = {{"1", {"left", "right", "matches"}}};
  ResultFolder b = a;
  b.evaluations = {
      evaluation_of("joint", {placed_line("0", 6.0, 0.3), placed_line("1", 9.1, 0.1)})};
  EXPECT_EQ(compare_folders(std::vector{a, b}).comparisons.at(0).n_common, 2U);
  b.id_hashes["1"] = {"left", "right", "other matches"};
  const Comparison c = compare_folders(std::vector{a, b}).comparisons.at(0);
  EXPECT_TRUE(c.in_space);
  EXPECT_EQ(c.n_common, 1U);
  EXPECT_THAT(c.only_a, testing::ElementsAre(0, 0, 0, 1, 0)) << "0.4 m";
  EXPECT_THAT(c.only_b, testing::ElementsAre(0, 0, 1, 0, 0)) << "0.3 m";
}

TEST(CompareFolders, PairsARunWithItselfRenumbered) {
  ResultFolder a;
  std::vector<LineEvaluation> lines;
  for (int i = 0; i < 20; ++i) lines.push_back(placed_line(std::to_string(i), 0.3 * i, 0.01 * i));
  a.evaluations = {evaluation_of("x", lines)};
  std::ranges::reverse(lines);
  for (LineEvaluation& line : lines) line.id += "a";
  ResultFolder b;
  b.evaluations = {evaluation_of("x", lines)};
  const Comparison c = compare_folders(std::vector{a, b}).comparisons.at(0);
  EXPECT_EQ(c.n_common, 20U);
  EXPECT_EQ(c.classes.back().n_unchanged, 20U);
}

TEST(CompareFolders, TestsNothingOnFewPairs) {
  ResultFolder a;
  std::vector<LineEvaluation> lines;
  for (int i = 0; i < 20; ++i) lines.push_back(placed_line(std::to_string(i), 5.0 * i, 0.01 * i));
  a.evaluations = {evaluation_of("x", lines)};
  ResultFolder b;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].mean_distance_m = 0.1;
    if (i < 5) lines[i].segment->start.x() = lines[i].segment->end.x() = 900.0;
  }
  b.evaluations = {evaluation_of("x", lines)};
  const Comparison c = compare_folders(std::vector{a, b}).comparisons.at(0);
  EXPECT_EQ(c.n_common, 15U);
  EXPECT_FALSE(c.classes.back().wilcoxon_p);
  lines[0].segment = Segment3{{0, 0, 0}, {5, 0, 0}};
  b.evaluations = {evaluation_of("x", lines)};
  EXPECT_TRUE(compare_folders(std::vector{a, b}).comparisons.at(0).classes.back().wilcoxon_p)
      << "16 of 20";
}

TEST(WorseFigures, AreThoseOfAllLinesBeyondTheMargin) {
  const ComparisonReport report{{compare(evaluation_a(), evaluation_b(), "A", "B")}, {}};
  const ComparisonReport back{{compare(evaluation_b(), evaluation_a(), "A", "B")}, {}};
  const auto rms_m = [](const Summary& s) { return s.rms_m; };
  EXPECT_TRUE(worse_figures(report, rms_m, false, 0.0).empty()) << "A has a line at 9 m";
  EXPECT_EQ(worse_figures(back, rms_m, false, 1.0).size(), 1U);
  const auto share = [](const Summary& s) { return s.evaluated_share(); };
  EXPECT_EQ(worse_figures(report, share, true, 0.2).size(), 1U) << "1 to 0.75";
  EXPECT_TRUE(worse_figures(report, share, true, 0.25).empty());
  const ComparisonReport to_none{{compare(evaluation_a(), evaluation_of("x", {}), "A", "B")}, {}};
  ASSERT_EQ(worse_figures(to_none, rms_m, false, 1.0).size(), 1U);
  EXPECT_FALSE(worse_figures(to_none, rms_m, false, 1.0)[0].b);
}

TEST(CompareFolders, ComparesEachFolderWithTheFirst) {
  ResultFolder a;
  a.name = "a";
  a.evaluations = {evaluation_a()};
  ResultFolder b;
  b.name = "b";
  b.evaluations = {evaluation_b()};
  const ComparisonReport report = compare_folders(std::vector{a, b, a});
  ASSERT_EQ(report.comparisons.size(), 2U);
  EXPECT_EQ(report.comparisons[0].name_b, "b joint") << "the only evaluation of the patch";
  EXPECT_EQ(report.comparisons[1].classes.back().n_unchanged, 4U);
  EXPECT_TRUE(report.warnings.empty());
}

TEST(CompareFolders, PairsTheProductsOfRunsWithoutACommonMethod) {
  const auto of = [](const char* method, double off_m) {
    return evaluation_of(method, {evaluated_line("1", off_m, 1)});
  };
  ResultFolder older;
  older.name = "older";
  older.evaluations = {of("direct", 0.4), of("joint", 0.3)};
  ResultFolder newer;
  newer.name = "newer";
  newer.evaluations = {of("planes", 0.2), of("lines", 0.1)};
  const ComparisonReport report = compare_folders(std::vector{older, newer});
  ASSERT_EQ(report.comparisons.size(), 1U);
  EXPECT_EQ(report.comparisons[0].name_a, "older joint");
  EXPECT_EQ(report.comparisons[0].name_b, "newer lines");
}

TEST(CompareFolders, PairsTheSameMethodAndWarnsOfTheRest) {
  ResultFolder a;
  a.name = "a";
  a.evaluations = {evaluation_a(), evaluation_b()};
  ResultFolder b;
  b.name = "b";
  b.evaluations = {evaluation_b()};
  b.input_hashes = {{"x.las", "1"}};
  const ComparisonReport report = compare_folders(std::vector{a, b});
  ASSERT_EQ(report.comparisons.size(), 1U);
  EXPECT_EQ(report.comparisons[0].name_a, "a joint");
  ASSERT_EQ(report.warnings.size(), 2U);
  EXPECT_THAT(report.warnings[0], HasSubstr("input hashes differ"));
  EXPECT_THAT(report.warnings[1], HasSubstr("patch 1, direct"));
  b.evaluations[0].patch = "2";
  EXPECT_THROW(compare_folders(std::vector{a, b}), std::invalid_argument);
  EXPECT_THROW(compare_folders(std::vector{a}), std::invalid_argument);
}

TEST(CompareMethods, ComparesTheMethodsOfAFolderWithItsFirst) {
  ResultFolder folder;
  folder.evaluations = {evaluation_a(), evaluation_b()};
  const std::vector<Comparison> comparisons = compare_methods(folder);
  ASSERT_EQ(comparisons.size(), 1U);
  EXPECT_EQ(comparisons[0].name_a, "direct");
  EXPECT_EQ(comparisons[0].name_b, "joint");
}

std::optional<std::size_t> n_differing(std::optional<bool> joint_adjusts_to_faces) {
  ResultFolder folder;
  folder.evaluations = {evaluation_a(), evaluation_b()};
  folder.joint_adjusts_to_faces = joint_adjusts_to_faces;
  return compare_methods(folder).at(0).n_not_aligned_differing;
}

TEST(CompareMethods, LooksForADefectOnlyWhereDirectAndJointAreKnownToShareTheCode) {
  EXPECT_EQ(n_differing(false), 1U);
  EXPECT_EQ(n_differing(true), std::nullopt);
  EXPECT_EQ(n_differing(std::nullopt), std::nullopt) << "options that are not known";
}

TEST(CompareFolders, LooksForADefectOnlyWhereBothAreKnownToShareTheCode) {
  for (const bool a_adjusts : {false, true}) {
    for (const bool b_adjusts : {false, true}) {
      ResultFolder a;
      a.evaluations = {evaluation_a()};
      a.joint_adjusts_to_faces = a_adjusts;
      ResultFolder b;
      b.evaluations = {evaluation_b()};
      b.joint_adjusts_to_faces = b_adjusts;
      const ComparisonReport report = compare_folders(std::vector{a, b});
      EXPECT_EQ(report.comparisons.at(0).n_not_aligned_differing.has_value(),
                !a_adjusts && !b_adjusts);
    }
  }
}

TEST(ComparisonInATerminal, HasTheCellsOfTheMarkdownInAlignedColumns) {
  const ComparisonReport report{{compare(evaluation_a(), evaluation_b(), "a|b", "B")}, {"<odd>"}};
  const std::string text = to_terminal(report);
  EXPECT_THAT(text, StartsWith("Patch 1: A = a|b, B = B\n\nEach on its own lines:\n"));
  EXPECT_THAT(text, HasSubstr("On the common lines:\n"
                              "class        n  RMS A  RMS B  B / A           95 %  A - B"));
  EXPECT_THAT(text, HasSubstr("\naligned      2  0.707  0.515  0.728  0.250 - 1.167  0.192"));
  EXPECT_THAT(text, HasSubstr("\n\nLines with the largest increase from A to B:\nid  class        "
                              "A      B   A - B\na2  aligned  0.600  0.700  -0.100\n"));
  EXPECT_THAT(text, HasSubstr("Warning: <odd>\n"));
  EXPECT_THAT(text, AllOf(Not(HasSubstr("\\")), Not(HasSubstr("| ")), Not(HasSubstr("##"))));
}

TEST(ComparisonRenderings, AgreeToThePrintedDigit) {
  const ComparisonReport report{{compare(evaluation_a(), evaluation_b(), "A", "B")}, {"odd"}};
  const std::string text = to_markdown(report);
  EXPECT_THAT(text, HasSubstr("both 3, only in A 1, only in B 0."));
  EXPECT_THAT(text, HasSubstr("| aligned | 2 | 0.707 | 0.515 | 0.728 | 0.250 - 1.167 | 0.192 |"));
  EXPECT_LT(text.find("Each on its own lines"), text.find("On the common lines"));
  EXPECT_THAT(text, HasSubstr("differ on 1 not_aligned lines"));
  EXPECT_THAT(text, HasSubstr("Warning: odd"));
  const auto json = nlohmann::json::parse(to_json(report));
  EXPECT_NEAR(json["comparisons"][0]["common"][1]["rms_ratio"], std::sqrt(0.53), kComparisonTol);
  EXPECT_TRUE(json["comparisons"][0]["common"][0]["rms_ratio_ci95"].is_null());
}

}  // namespace
}  // namespace ridgeline::evaluate
