// SPDX-License-Identifier: BSD-3-Clause
// Which figures a gate applies to, and what it says of those that do not exist.
#include "evaluate/gates/figure.h"
#include "evaluate/gates/metric.h"
#include "tests/evaluate/statistics/gate_scene.h"

#include <gmock/gmock.h>

namespace ridgeline::evaluate {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// The results of several methods on patch 1.
ResultFolder results_of(const std::vector<std::string>& methods) {
  ResultFolder folder = results_with(0.1);
  folder.evaluations.clear();
  for (const std::string& method : methods) {
    folder.evaluations.push_back(results_with(0.1, method).evaluations[0]);
  }
  return folder;
}

/// "patch method" of every figure that a gate concerns.
std::vector<std::string> scope(const Gate& gate, const ResultFolder& folder) {
  std::vector<std::string> result;
  for (const Figure& f : figures_of(gate, gate.line_class, folder)) {
    result.push_back(f.patch + " " + f.method);
  }
  return result;
}

/// Why the only figure that a gate concerns has no value.
std::string why_missing(const Gate& gate, const ResultFolder& folder) {
  const std::vector<Figure> figures = figures_of(gate, gate.line_class, folder);
  EXPECT_EQ(figures.size(), 1U);
  EXPECT_FALSE(figures.at(0).value);
  return figures.at(0).why_missing;
}

TEST(FiguresOf, AreOfTheProductMethodUnlessTheGateNamesOne) {
  Gate gate = gate_on("total");
  EXPECT_THAT(scope(gate, results_of({"direct", "lines", "network"})), ElementsAre("1 lines"));
  EXPECT_THAT(scope(gate, results_of({"direct", "joint", "network"})), ElementsAre("1 network"));
  EXPECT_THAT(scope(gate, results_of({"planes", "joint"})), ElementsAre("1 joint"));
  EXPECT_THAT(scope(gate, results_of({"direct", "joint"})), ElementsAre("1 joint"));
  EXPECT_THAT(scope(gate, results_of({"direct"})), ElementsAre("1 direct"));
  gate.method = "direct";
  EXPECT_THAT(scope(gate, results_of({"direct", "joint", "network"})), ElementsAre("1 direct"));
}

TEST(FiguresOf, AreOfTheNumberOfImagesThatTheGateNames) {
  ResultFolder folder = results_of({"joint"});
  std::vector<LineEvaluation>& lines = folder.evaluations[0].lines;
  lines[0].n_images = lines[1].n_images = 3;  // one of each class: 0.1 m off
  lines[2].n_images = 7;
  lines[2].mean_distance_m = 0.4;
  Gate gate = gate_on("total");
  gate.n_images = 3;
  EXPECT_EQ(figures_of(gate, "total", folder).at(0).n, 2U);
  EXPECT_EQ(figures_of(gate, "aligned", folder).at(0).n, 1U);
  gate.n_images = 5;
  EXPECT_DOUBLE_EQ(*figures_of(gate, "total", folder).at(0).value, 0.4);
  gate.max = 0.3;
  EXPECT_EQ(only_result(gate, folder).rule, "total rms_m of 5 and more images <= 0.3");
  gate.n_images = 4;
  EXPECT_THAT(why_missing(gate, folder), HasSubstr("that 4 images show"));
  for (const int wrong : {1, 6}) {
    gate.n_images = wrong;
    EXPECT_THROW(validate(gate), std::invalid_argument);
  }
}

TEST(FiguresOf, AreOfTheLinesThatTheEvidenceOfTheGateDecidedOn) {
  ResultFolder folder = results_of({"joint"});
  Gate gate = gate_on("total");
  gate.max = 0.3;
  gate.decided_by = DecidedGroup::kPointsPlace;
  EXPECT_THAT(why_missing(gate, folder), HasSubstr("decided by points_place"));
  Evaluation& e = folder.evaluations[0];
  e.lines[0].decided_by = DecidedBy::kPlace;
  e.lines[0].mean_distance_m = 0.4;
  e = with_summaries(std::move(e));
  EXPECT_DOUBLE_EQ(*figures_of(gate, "total", folder).at(0).value, 0.4);
  EXPECT_EQ(only_result(gate, folder).rule, "total rms_m decided by points_place <= 0.3");
  gate.decided_by = DecidedGroup::kPlanImages;
  const Figure headline = figures_of(gate, "total", folder).at(0);
  EXPECT_NEAR(*headline.value, 0.1, 1e-12);
  EXPECT_EQ(headline.n, 59U);
  EXPECT_NEAR(*headline.evaluated_share, 59.0 / 65.0, 1e-12);
  gate.decided_by.reset();
  EXPECT_EQ(figures_of(gate, "total", folder).at(0).n, 60U) << "all that were judged";
  gate.metric = "correctness";
  gate.decided_by = DecidedGroup::kPlanImages;
  EXPECT_THROW(validate(gate), std::invalid_argument);
}

TEST(FiguresOf, AreOfEveryLineFileOfAnEvaluation) {
  ResultFolder folder = results_of({"direct", "joint", "roofs"});
  folder.is_of_line_files = true;
  EXPECT_THAT(scope(gate_on("total"), folder), ElementsAre("1 direct", "1 joint", "1 roofs"));
  folder.is_of_line_files = false;
  EXPECT_THAT(scope(gate_on("total"), folder), ElementsAre("1 joint"));
}

TEST(FiguresOf, AreOfThePatchThatTheGateNamesOrOfEach) {
  ResultFolder folder = results_of({"direct", "joint"});
  folder.evaluations.push_back(results_with(0.1, "direct").evaluations[0]);
  folder.evaluations.back().patch = "2";
  Gate gate = gate_on("total");
  EXPECT_THAT(scope(gate, folder), ElementsAre("1 joint", "2 direct"));
  gate.patch = "2";
  EXPECT_THAT(scope(gate, folder), ElementsAre("2 direct"));
}

TEST(FiguresOf, LackOnePatchIsNotHiddenByTheOther) {
  ResultFolder folder = results_of({"joint"});
  folder.evaluations.push_back(results_with(0.1, "direct").evaluations[0]);
  folder.evaluations.back().patch = "2";
  Gate gate = gate_on("total");
  gate.method = "joint";
  const std::vector<Figure> figures = figures_of(gate, gate.line_class, folder);
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_FALSE(figures[1].value);
  EXPECT_EQ(figures[1].why_missing,
            "there is no method joint; available: direct; run with `methods` direct,joint");
  gate = gate_on("total", "quality");
  const std::vector<Figure> matching = figures_of(gate, gate.line_class, folder);
  ASSERT_EQ(matching.size(), 2U);
  EXPECT_THAT(matching[1].why_missing, HasSubstr("needs reference_matches"));
}

TEST(FiguresOf, AreOfTheMatcherThatWasRun) {
  ResultFolder folder = results_with(0.1);
  Gate gate = gate_on("total", "quality");
  EXPECT_THAT(scope(gate, folder), ElementsAre("1 pairwise"));
  gate.method = "pairwise";
  EXPECT_THAT(scope(gate, folder), ElementsAre("1 pairwise"));
  gate.method = "joint";
  EXPECT_EQ(why_missing(gate, folder), "there is no matcher joint; available: pairwise");
}

TEST(FiguresOf, SayWhichPatchesMethodsAndMatchersThereAre) {
  Gate gate = gate_on("total");
  gate.patch = "7";
  EXPECT_EQ(why_missing(gate, results_with(0.1)), "there is no patch 7; available: 1");
  gate = gate_on("total");
  gate.method = "network";
  EXPECT_EQ(why_missing(gate, results_of({"direct", "joint"})),
            "there is no method network; available: direct, joint; run with `methods` "
            "direct,joint,network");
  EXPECT_EQ(why_missing(gate_on("total"), ResultFolder{}), "there are no results");
  ResultFolder of_files = results_with(0.1);
  of_files.is_of_line_files = true;
  of_files.matching.rows.clear();
  EXPECT_THAT(why_missing(gate_on("total", "quality"), of_files),
              HasSubstr("which run and demo do"));
}

TEST(FiguresOf, SayHowToGetAClassThatCannotExist) {
  ResultFolder folder = results_with(0.1);
  EXPECT_EQ(why_missing(gate_on("roof"), folder),
            "these lines have no class roof, only not_aligned, aligned, total");
  Evaluation& e = folder.evaluations[0];
  for (LineEvaluation& line : e.lines) line.line_class = "all";
  e = with_summaries(std::move(e));
  EXPECT_TRUE(figures_of(gate_on("total"), "total", folder).at(0).value);
  EXPECT_THAT(why_missing(gate_on("aligned"), folder),
              AllOf(HasSubstr("no class aligned, only total"), HasSubstr("evaluate `patch`"),
                    HasSubstr("column class")));
}

TEST(FiguresOf, SayWhyACellHasNoFigure) {
  ResultFolder folder = results_with(0.1);
  Evaluation& e = folder.evaluations[0];
  std::erase_if(e.lines, [](const LineEvaluation& l) { return l.line_class == "aligned"; });
  e = with_summaries(std::move(e));
  EXPECT_EQ(why_missing(gate_on("aligned"), folder), "no line has class aligned");
  std::erase_if(e.lines, [](const LineEvaluation& l) { return l.status == Status::kEvaluated; });
  e = with_summaries(std::move(e));
  EXPECT_EQ(why_missing(gate_on("total"), folder),
            "none of the 5 lines of class total was evaluated");
  e.lines = {evaluated_line("0", 0.1, 1)};
  e = with_summaries(std::move(e));
  EXPECT_EQ(why_missing(gate_on("total", "std_m"), folder), "n = 1 lines have no std_m");
}

TEST(FiguresOf, ExistForEveryMetricThatIsListed) {
  const ResultFolder folder = results_with(0.1);
  std::vector<Metric> metrics = accuracy_metrics();
  for (const Metric& metric : matching_metrics()) metrics.push_back(metric);
  for (const Metric& metric : metrics) {
    const std::string name(metric.name);
    const std::vector<Figure> figures = figures_of(gate_on("total", name), "total", folder);
    ASSERT_EQ(figures.size(), 1U);
    EXPECT_TRUE(figures[0].value) << name << ": " << figures[0].why_missing;
    EXPECT_GT(figures[0].n, 0U) << name;
  }
}

/// Lines of ten buildings: the i-th has two lines, i/10 and i/5 m off. One more line is of none,
/// and one was not judged.
ResultFolder buildings() {
  Evaluation e;
  e.patch = "1";
  e.method = "model";
  for (int i = 0; i < 10; ++i) {
    for (const int k : {1, 2}) {
      e.lines.push_back(evaluated_line(std::to_string(10 * i + k), 0.1 * i * k, 1));
      e.lines.back().building = std::to_string(i);
    }
  }
  e.lines.push_back(evaluated_line("lone", 9.0, 1));
  e.lines.push_back(excluded_line("out", Status::kNoLidar));
  e.lines.back().building = "11";
  ResultFolder folder;
  folder.evaluations.push_back(with_summaries(std::move(e)));
  return folder;
}

TEST(FiguresOf, BuildingsAreSharesOfThoseWithJudgedLines) {
  Gate gate = gate_on("total", "buildings_within_m");
  gate.min = 0.4;
  gate.within_m = 0.5;  // the RMS of the i-th is 0.158 i
  const GateResult result = only_result(gate, buildings());
  EXPECT_DOUBLE_EQ(*result.value, 0.4);
  EXPECT_EQ(result.n, 10U);
  EXPECT_EQ(result.verdict, Verdict::kPassed);
  EXPECT_EQ(result.rule, "total buildings_within_m 0.5 >= 0.4");
  gate.within_m = 0.47;
  EXPECT_DOUBLE_EQ(*only_result(gate, buildings()).value, 0.3);
  EXPECT_EQ(only_result(gate, results_with(0.1)).verdict, Verdict::kMissing);
}

TEST(ValidateGate, WithinBelongsToBuildings) {
  Gate gate = gate_on("total", "buildings_within_m");
  gate.min = 0.4;
  EXPECT_THROW(validate(gate), std::invalid_argument);
  gate.within_m = -1.0;
  EXPECT_THROW(validate(gate), std::invalid_argument);
  gate.within_m = 0.0;
  EXPECT_NO_THROW(validate(gate));
  gate.metric = "evaluated_share";
  EXPECT_THROW(validate(gate), std::invalid_argument);
}

TEST(ApplyGates, SaysWhatTheBaselineLacks) {
  Gate gate = gate_on("total");
  gate.max_increase_over_baseline = BaselineIncrease{0.02};
  const ResultFolder baseline = results_of({"direct", "joint"});
  const GateResult result = only_result(gate, results_of({"network"}), &baseline);
  EXPECT_EQ(result.verdict, Verdict::kMissing);
  EXPECT_EQ(result.explanation,
            "the baseline has no such figure: there is no method network; available: direct, "
            "joint; run with `methods` direct,joint,network");
}

}  // namespace
}  // namespace ridgeline::evaluate
