// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/gates/gate.h"

#include "evaluate/gates/gate_report.h"
#include "evaluate/gates/metric.h"
#include "tests/evaluate/statistics/gate_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(ApplyGates, ComparesThePointEstimateWithAnAbsoluteLimit) {
  Gate gate = gate_on("aligned");
  gate.max = 0.25;
  const GateResult passed = only_result(gate, results_with(0.2));
  EXPECT_EQ(passed.verdict, Verdict::kPassed);
  EXPECT_NEAR(*passed.value, 0.2, 1e-12);
  EXPECT_EQ(passed.n, 30U);
  EXPECT_EQ(passed.patch, "1");
  EXPECT_EQ(only_result(gate, results_with(0.3)).verdict, Verdict::kFailed);
  gate.max.reset();
  gate.min = 0.25;
  EXPECT_EQ(only_result(gate, results_with(0.2)).verdict, Verdict::kFailed);
}

TEST(ApplyGates, FailsWhereTheFigureIsMissing) {
  Gate gate = gate_on("aligned");
  gate.max = 1.0;
  gate.patch = "7";
  EXPECT_EQ(only_result(gate, results_with(0.1)).verdict, Verdict::kMissing);
  gate.patch.reset();
  gate.method = "network";
  EXPECT_EQ(only_result(gate, results_with(0.1)).verdict, Verdict::kMissing);
  gate = gate_on("eave");
  gate.max = 1.0;
  EXPECT_EQ(only_result(gate, results_with(0.1)).verdict, Verdict::kMissing);
}

TEST(ApplyGates, FailsWithoutAnyResult) {
  EXPECT_FALSE(apply_gates({}, results_with(0.1)).passed());
  Gate gate = gate_on("total");
  gate.max = 1.0;
  EXPECT_FALSE(apply_gates(std::vector{gate}, ResultFolder{}).passed());
}

TEST(ApplyGates, FailsOnTooFewLines) {
  Gate gate = gate_on("aligned");
  gate.max = 1.0;
  gate.n_min = 31;
  const GateResult result = only_result(gate, results_with(0.1));
  EXPECT_EQ(result.verdict, Verdict::kInsufficient);
  EXPECT_THAT(result.explanation, StartsWith("n = 30"));
}

TEST(ApplyGates, AsksForNoNumberOfLinesThatNobodyWrote) {
  Gate gate = gate_on("total");
  gate.max = 1.0;
  ResultFolder results = results_with(0.1);
  Evaluation& e = results.evaluations[0];
  e.lines.resize(1);
  e = with_summaries(std::move(e));
  const GateResult result = only_result(gate, results);
  EXPECT_EQ(result.verdict, Verdict::kPassed);
  EXPECT_EQ(result.rule, "total rms_m <= 1");
  gate.n_min = 20;
  const GateResult limited = only_result(gate, results);
  EXPECT_EQ(limited.verdict, Verdict::kInsufficient);
  EXPECT_EQ(limited.rule, "total rms_m <= 1 (n >= 20)");
}

TEST(ApplyGates, RelatesOneClassToAnother) {
  Gate gate = gate_on("aligned");
  gate.max_ratio_to_class = "not_aligned";
  const GateResult passed = only_result(gate, results_with(0.24));
  EXPECT_EQ(passed.verdict, Verdict::kPassed);
  EXPECT_NEAR(*passed.limit, 0.25, 1e-12);
  EXPECT_EQ(only_result(gate, results_with(0.26)).verdict, Verdict::kFailed);
  gate.max_ratio_to_class = "eave";
  EXPECT_EQ(only_result(gate, results_with(0.1)).verdict, Verdict::kMissing);
}

TEST(ApplyGates, AllowsTheLargerOfTwoMillimetresAndFivePercentOverTheBaseline) {
  Gate gate = gate_on("aligned");
  gate.max_increase_over_baseline = BaselineIncrease{};
  const ResultFolder baseline = results_with(0.2);
  EXPECT_EQ(only_result(gate, results_with(0.2099), &baseline).verdict, Verdict::kPassed);
  EXPECT_EQ(only_result(gate, results_with(0.2101), &baseline).verdict, Verdict::kFailed);
  const ResultFolder fine = results_with(0.01);
  EXPECT_EQ(only_result(gate, results_with(0.0119), &fine).verdict, Verdict::kPassed);
  EXPECT_EQ(only_result(gate, results_with(0.0121), &fine).verdict, Verdict::kFailed);
  gate.max_increase_over_baseline = BaselineIncrease{0.05};
  EXPECT_EQ(only_result(gate, results_with(0.249), &baseline).verdict, Verdict::kPassed);
  EXPECT_EQ(only_result(gate, results_with(0.251), &baseline).verdict, Verdict::kFailed);
}

TEST(ApplyGates, SaysWhenTheBaselineCanBeTightened) {
  Gate gate = gate_on("aligned");
  gate.max_increase_over_baseline = BaselineIncrease{};
  const ResultFolder baseline = results_with(0.2);
  EXPECT_TRUE(only_result(gate, results_with(0.18), &baseline).baseline_can_be_tightened);
  EXPECT_FALSE(only_result(gate, results_with(0.195), &baseline).baseline_can_be_tightened);
}

TEST(ApplyGates, FailsABaselineRuleWithoutBaseline) {
  Gate gate = gate_on("total");
  gate.max_increase_over_baseline = BaselineIncrease{};
  const GateResult result = only_result(gate, results_with(0.1));
  EXPECT_EQ(result.verdict, Verdict::kMissing);
  EXPECT_EQ(result.explanation, "no baseline is given (`baseline`)");
}

TEST(ApplyGates, RefusesABaselineOfOtherInputs) {
  Gate gate = gate_on("total");
  gate.max = 1.0;
  const std::vector gates{gate};
  ResultFolder other = results_with(0.1);
  other.input_hashes = {{"lidar.las", "cd34"}};
  EXPECT_THROW(apply_gates(gates, results_with(0.1), &other), std::invalid_argument);
  other.input_hashes = {{"lidar.las", "ab12"}, {"left.tif", "00"}};
  EXPECT_THROW(apply_gates(gates, results_with(0.1), &other), std::invalid_argument);
  const ResultFolder less = results_with(0.1);
  EXPECT_THROW(apply_gates(gates, other, &less), std::invalid_argument);
  other.input_hashes.clear();
  EXPECT_THROW(apply_gates(gates, results_with(0.1), &other), std::invalid_argument);
}

TEST(ApplyGates, RefusesABaselineOfOtherInputsOfOneNameInAnotherPatch) {
  Gate gate = gate_on("total");
  gate.max = 1.0;
  const std::vector gates{gate};
  ResultFolder results = results_with(0.1);
  results.input_hashes = {{"lidar.las", "ab12"}, {"lidar.las", "cd34"}};
  ResultFolder other = results;
  EXPECT_NO_THROW(apply_gates(gates, results, &other));
  other.input_hashes = {{"lidar.las", "00"}, {"lidar.las", "cd34"}};
  EXPECT_THROW(apply_gates(gates, results, &other), std::invalid_argument);
}

TEST(ApplyGates, NamesTheAllowanceInTheRule) {
  Gate gate = gate_on("total");
  gate.max_increase_over_baseline = BaselineIncrease{0.03};
  const ResultFolder baseline = results_with(0.2);
  EXPECT_EQ(only_result(gate, baseline, &baseline).rule, "total rms_m <= baseline + 0.03");
}

TEST(ApplyGates, HasTheSameRuleWithEveryBaseline) {
  Gate gate = gate_on("total");
  gate.max_increase_over_baseline = BaselineIncrease{};
  for (const double rms_m : {0.01, 0.2}) {
    const ResultFolder baseline = results_with(rms_m);
    EXPECT_EQ(only_result(gate, baseline, &baseline).rule,
              "total rms_m <= baseline + max(0.002, 5 %)");
  }
}

TEST(ApplyGates, HoldsNothingAgainstTheBaselineThatNobodyWrote) {
  Gate gate = gate_on("total", "evaluated_share");
  gate.min = 0.8;
  const ResultFolder results = results_with(0.1);  // 60 of 65 lines are evaluated
  ResultFolder baseline = results;
  Evaluation& e = baseline.evaluations[0];
  std::erase_if(e.lines, [](const LineEvaluation& l) { return l.status != Status::kEvaluated; });
  e = with_summaries(std::move(e));
  const GateReport report = apply_gates(std::vector{gate}, results, &baseline);
  ASSERT_EQ(report.results.size(), 1U);
  EXPECT_EQ(report.results[0].verdict, Verdict::kPassed);
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_THAT(report.warnings[0], StartsWith("no gate refers to the baseline"));

  gate.min.reset();
  gate.max_decrease_below_baseline = 0.02;
  const GateResult written = only_result(gate, results, &baseline);
  EXPECT_EQ(written.verdict, Verdict::kFailed) << "0.92 against 1 - 0.02";
  EXPECT_EQ(written.rule, "total evaluated_share >= baseline - 0.02");
}

TEST(ApplyGates, GatesMatchingFiguresAgainstTheBaseline) {
  Gate gate = gate_on("total", "quality");
  gate.max_decrease_below_baseline = 0.01;
  const ResultFolder baseline = results_with(0.1);
  ResultFolder results = baseline;
  EXPECT_EQ(only_result(gate, results, &baseline).verdict, Verdict::kPassed);
  results.matching.rows[0].counts = {88, 12, 12};
  EXPECT_EQ(only_result(gate, results, &baseline).verdict, Verdict::kFailed);
  results.matching.rows.clear();
  EXPECT_EQ(only_result(gate, results, &baseline).verdict, Verdict::kMissing);
}

TEST(ApplyGates, PrintsTheIntervalAndTheDenominatorOfAMatchingFigure) {
  Gate gate = gate_on("total", "correctness");
  gate.min = 0.5;
  gate.n_min = 100;
  ResultFolder results = results_with(0.1);
  results.matching.rows[0].counts = {90, 10, 70};
  const GateResult result = only_result(gate, results);
  EXPECT_EQ(result.verdict, Verdict::kPassed);
  EXPECT_EQ(result.n, 100U) << "90 of 90 + 10, whatever is missed";
  ASSERT_TRUE(result.ci95);
  EXPECT_LT(result.ci95->low, 0.9);
  EXPECT_GT(result.ci95->high, 0.9);
}

TEST(ApplyGates, RejectsAGateThatCannotDecide) {
  const ResultFolder results = results_with(0.1);
  const auto apply = [&](const Gate& gate) { apply_gates(std::vector{gate}, results); };
  EXPECT_THROW(apply(gate_on("total")), std::invalid_argument) << "no rule";
  Gate gate = gate_on("total", "rms");
  gate.max = 1.0;
  EXPECT_THROW(apply(gate), std::invalid_argument) << "unknown metric";
  gate = gate_on("total");
  gate.max = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(apply(gate), std::invalid_argument);
  gate = gate_on("total");
  gate.max_increase_over_baseline = BaselineIncrease{-0.1};
  EXPECT_THROW(apply(gate), std::invalid_argument);
}

TEST(Validate, RejectsARuleThatTheFigureCannotHave) {
  Gate gate = gate_on("total", "quality");
  gate.max_ratio_to_class = "aligned";
  EXPECT_THROW(validate(gate), std::invalid_argument) << "matching has no classes";
  gate = gate_on("aligned", "quality");
  gate.min = 0.5;
  EXPECT_THROW(validate(gate), std::invalid_argument) << "matching has no classes";
  gate = gate_on("aligned", "mean_m");
  gate.max_ratio_to_class = "not_aligned";
  EXPECT_THROW(validate(gate), std::invalid_argument) << "a ratio of a signed figure";
  gate = gate_on("total", "evaluated_share");
  gate.min = 80.0;
  EXPECT_THROW(validate(gate), std::invalid_argument) << "a share in percent";
  gate.min = 0.8;
  EXPECT_NO_THROW(validate(gate));
  gate.max_increase_over_baseline = BaselineIncrease{};
  EXPECT_THROW(validate(gate), std::invalid_argument) << "the default allowance is in metres";
  gate = gate_on("total");
  gate.max_decrease_below_baseline = -0.1;
  EXPECT_THROW(validate(gate), std::invalid_argument);
}

TEST(ApplyGates, WarnsOfTheCalibrationOfGatedLinesOnly) {
  Gate gate = gate_on("total");
  gate.max = 1.0;
  ResultFolder results = results_with(0.1);
  results.evaluations.push_back(results_with(0.1, "direct").evaluations[0]);
  for (LineEvaluation& line : results.evaluations[1].lines) line.sigma_line_m = 0.01;
  EXPECT_TRUE(apply_gates(std::vector{gate}, results).warnings.empty());
  gate.method = "direct";
  EXPECT_EQ(apply_gates(std::vector{gate}, results).warnings.size(), 1U);
}

TEST(ApplyGates, WarnsOfCalibrationAndTimeWithoutFailing) {
  Gate gate = gate_on("total");
  gate.max = 1.0;
  ResultFolder results = results_with(0.1);
  for (LineEvaluation& line : results.evaluations[0].lines) line.sigma_line_m = 0.01;
  results.duration_s = 21.0;
  ResultFolder baseline = results_with(0.1);
  baseline.duration_s = 10.0;
  gate.max_increase_over_baseline = BaselineIncrease{0.1};
  const GateReport report = apply_gates(std::vector{gate}, results, &baseline);
  EXPECT_TRUE(report.passed());
  ASSERT_EQ(report.warnings.size(), 2U);
  EXPECT_THAT(report.warnings[0], HasSubstr("mean NEES / dof = 100 (n = 60)"));
  EXPECT_THAT(report.warnings[1], HasSubstr("21.0 s"));
}

GateReport mixed_report() {
  Gate good = gate_on("total");
  good.max = 1.0;
  Gate bad = gate_on("aligned");
  bad.max = 0.1;
  return apply_gates(std::vector{good, bad}, results_with(0.3));
}

TEST(Junit, RepeatsTheNumbersInTheFailuresBody) {
  const std::string xml = to_junit(mixed_report(), "2026-01-02T03:04:05");
  EXPECT_THAT(xml, HasSubstr("tests=\"2\" failures=\"1\" errors=\"0\" skipped=\"0\""));
  EXPECT_THAT(xml, HasSubstr("timestamp=\"2026-01-02T03:04:05\""));
  EXPECT_THAT(xml, HasSubstr("name=\"aligned rms_m &lt;= 0.1 (patch 1, joint)\""));
  EXPECT_THAT(xml, HasSubstr("value: 0.3000\n"));
  EXPECT_THAT(xml, HasSubstr("limit: 0.1000\n"));
  EXPECT_THAT(xml, HasSubstr("n: 30\ncoverage: 1.0000\n"));
  EXPECT_THAT(xml, EndsWith("</testsuites>\n"));
}

TEST(Junit, HoldsNoControlCharacterNorMarkupFromNames) {
  GateReport report = mixed_report();
  report.results[1].patch = "<\x02&>";
  const std::string xml = to_junit(report, "");
  EXPECT_THAT(xml, Not(HasSubstr("\x02")));
  EXPECT_THAT(xml, HasSubstr("&lt;\xEF\xBF\xBD&amp;&gt;"));
}

TEST(Junit, IsUtf8WhateverTheNamesAre) {
  GateReport report = mixed_report();
  report.results[1].patch = "caf\xE9";
  EXPECT_THAT(to_junit(report, ""), HasSubstr("(patch caf\xEF\xBF\xBD, joint)"));
}

TEST(Junit, KeepsTheLevelsOfAClassNameWhateverTheNamesHold) {
  GateReport report = mixed_report();
  report.results[1].patch = "tiles/v1.2 <a>";
  report.results[1].method = "roofs.good";
  const std::string xml = to_junit(report, "");
  EXPECT_THAT(xml, HasSubstr("classname=\"ridgeline.gate.tiles_v1_2__a_.roofs_good\""));
  EXPECT_THAT(xml, HasSubstr("(patch tiles/v1.2 &lt;a&gt;, roofs.good)"));
}

TEST(GateMarkdown, PutsFailuresFirstAndStaysBelowItsLimit) {
  GateReport report = mixed_report();
  const std::string text = to_markdown(report);
  EXPECT_THAT(text, StartsWith("Accuracy gate: **failed** (1 of 2 checks passed)."));
  EXPECT_LT(text.find("aligned rms_m"), text.find("total rms_m"));
  for (int i = 0; i < 500; ++i) report.results.push_back(report.results[0]);
  constexpr std::size_t kLimit = 5000;
  const std::string cut = to_markdown(report, kLimit);
  EXPECT_LE(cut.size(), kLimit);
  EXPECT_THAT(cut, HasSubstr("more rows: see the JUnit file"));
}

TEST(GateInATerminal, HasTheReasonOfAFailureBelowItsRowAndNoMarkup) {
  GateReport report = mixed_report();
  report.warnings = {"odd"};
  const std::string text = to_terminal(report);
  EXPECT_THAT(text, StartsWith("Accuracy gate: failed (1 of 2 checks passed).\n\ngate  "));
  EXPECT_THAT(text, ContainsRegex("verdict\naligned rms_m <= .* failed\n  [^ ].* is above the "
                                  "limit [0-9.]+\ntotal rms_m <= .* passed\n$"));
  EXPECT_THAT(text, AllOf(Not(HasSubstr("\\")), Not(HasSubstr("|")), Not(HasSubstr("*"))));
  EXPECT_THAT(text, Not(HasSubstr("baseline"))) << "no gate has one";
}

TEST(GateInATerminal, HasAllRowsAndTheBaselineWhereThereIsOne) {
  GateReport report = mixed_report();
  report.results[0].baseline = 0.25;
  report.results[0].baseline_can_be_tightened = true;
  EXPECT_THAT(to_terminal(report), AllOf(HasSubstr("  baseline  "), HasSubstr("  0.2500  "),
                                         HasSubstr(" passed\n  baseline can be tightened\n")));
  EXPECT_THAT(to_markdown(report), HasSubstr("| passed: baseline can be tightened |\n"));
  for (int i = 0; i < 20'000; ++i) report.results.push_back(report.results[0]);
  EXPECT_GT(to_terminal(report).size(), kMaxSummaryBytes);
}

TEST(GateJson, HoldsTheVerdictAndEveryNumber) {
  const auto json = nlohmann::json::parse(to_json(mixed_report()));
  EXPECT_FALSE(json["passed"]);
  EXPECT_EQ(json["gates"][1]["verdict"], "failed");
  EXPECT_TRUE(json["gates"][1]["baseline"].is_null());
}

TEST(Annotations, AreEscapedAndAtMostTenPerType) {
  EXPECT_EQ(escape_annotation("5 %: a,b\r\n"), "5 %25: a,b%0D%0A");
  EXPECT_EQ(escape_annotation_property("a:b,c"), "a%3Ab%2Cc");
  GateReport report = mixed_report();
  for (int i = 0; i < 20; ++i) {
    report.results.push_back(report.results[1]);
    report.warnings.emplace_back("slow");
  }
  const std::vector<std::string> commands = to_annotations(report);
  EXPECT_EQ(commands.size(), 20U);
  EXPECT_THAT(commands[0], StartsWith("::error title=Gate aligned rms_m <= 0.1::patch 1"));
  EXPECT_THAT(commands[19], StartsWith("::warning title=Gate::slow"));
}

}  // namespace
}  // namespace ridgeline::evaluate
