// SPDX-License-Identifier: BSD-3-Clause
// Completeness in the files of an evaluation, in tables and in gates.
#include "evaluate/tables/completeness_table.h"
#include "evaluate/tables/evaluation_json.h"
#include "tests/evaluate/statistics/gate_scene.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

using testing::AllOf;
using testing::HasSubstr;

ExpectedEdge edge_of(double x_m, const char* kind, double covered, std::uint64_t plane) {
  return {.segment = {{x_m, 0.0, 8.0}, {x_m + 5.0, 0.0, 8.0}},
          .kind = kind,
          .length_m = 5.0,
          .support = 0.9,
          .covered = covered,
          .planes = {plane}};
}

/// Of four ridges three are found, of two eaves one.
Completeness three_of_four_ridges() {
  Completeness c{.area_from = "lines", .area_m2 = 12345.0, .n_lines = 60, .n_without_edge = 7};
  c.edges = {edge_of(0.0, "ridge", 1.0, 1),  edge_of(10.0, "ridge", 0.75, 2),
             edge_of(20.0, "ridge", 0.5, 3), edge_of(30.0, "ridge", 0.25, 4),
             edge_of(40.0, "eave", 1.0, 5),  edge_of(50.0, "eave", 0.0, 6)};
  c.edges.push_back(edge_of(60.0, "eave", 0.0, 7));
  c.edges.back().is_shown = false;
  c.rows = completeness_rows(c.edges, {});
  return c;
}

ResultFolder with_completeness() {
  ResultFolder folder = results_with(0.1);
  folder.evaluations[0].completeness = three_of_four_ridges();
  return folder;
}

Gate scan_gate(const char* metric, double min, std::optional<std::string> kind = {}) {
  Gate gate;
  gate.metric = metric;
  gate.min = min;
  gate.kind = std::move(kind);
  return gate;
}

std::string refused_because(const Gate& gate) {
  try {
    validate(gate);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ScanGate, ComparesTheShareOfTheEdgesOfAKind) {
  const ResultFolder folder = with_completeness();
  const GateResult ridges = only_result(scan_gate("scan_recall", 0.75, "ridge"), folder);
  EXPECT_EQ(ridges.verdict, Verdict::kPassed);
  EXPECT_EQ(ridges.value, 0.75);
  EXPECT_EQ(ridges.n, 4U);
  EXPECT_EQ(ridges.n_clusters, 4U);
  EXPECT_TRUE(ridges.ci95);
  EXPECT_EQ(ridges.rule, "scan_recall ridge >= 0.75");
  EXPECT_EQ(only_result(scan_gate("scan_recall", 0.76, "ridge"), folder).verdict, Verdict::kFailed);
}

TEST(ScanGate, CoversAllKindsByDefault) {
  const ResultFolder folder = with_completeness();
  EXPECT_EQ(only_result(scan_gate("scan_recall", 0.5), folder).n, 6U);
  const GateResult by_length = only_result(scan_gate("scan_recall_length", 0.5), folder);
  EXPECT_NEAR(*by_length.value, 3.5 / 6.0, 1e-12);
  EXPECT_FALSE(by_length.ci95);
  EXPECT_EQ(by_length.rule, "scan_recall_length >= 0.5");
}

TEST(ScanGate, WithoutTheFigureFailsWithTheReason) {
  const GateResult none = only_result(scan_gate("scan_recall", 0.5), results_with(0.1));
  EXPECT_EQ(none.verdict, Verdict::kMissing);
  EXPECT_THAT(none.explanation, HasSubstr("not compared with the edges of the scan"));
  const GateResult no_hip = only_result(scan_gate("scan_recall", 0.5, "hip"), with_completeness());
  EXPECT_EQ(no_hip.verdict, Verdict::kMissing);
  EXPECT_THAT(no_hip.explanation, HasSubstr("no hip"));
}

TEST(ScanGate, RefusesWhatDoesNotApply) {
  EXPECT_EQ(refused_because(scan_gate("scan_recall", 0.5, "verge")), "");
  EXPECT_THAT(refused_because(scan_gate("scan_recall", 0.5, "height")),
              AllOf(HasSubstr("kind: height"), HasSubstr("ridge, hip, valley")));
  EXPECT_THAT(refused_because(scan_gate("scan_recall", 1.5)), HasSubstr("must be 0 to 1"));
  Gate gate = scan_gate("scan_recall", 0.5);
  gate.line_class = "aligned";
  EXPECT_THAT(refused_because(gate), HasSubstr("class: aligned; scan_recall"));
  gate = scan_gate("scan_recall_length", 0.5);
  gate.distance_m = 1.0;
  EXPECT_THAT(refused_because(gate), HasSubstr("distance_m"));
  gate = scan_gate("rms_m", 0.5, "ridge");
  EXPECT_THAT(refused_because(gate), HasSubstr("kind: rms_m does not use it"));
}

TEST(CompletenessJson, IsReadBack) {
  Evaluation written = results_with(0.1).evaluations[0];
  written.origin_m = {512000.0, 5403000.0, 0.0};
  EXPECT_THAT(to_json(written), Not(HasSubstr("completeness")));
  written.completeness = three_of_four_ridges();
  const Evaluation read = parse_evaluation(to_json(written));
  ASSERT_TRUE(read.completeness);
  EXPECT_EQ(to_json(read), to_json(written));
  EXPECT_EQ(read.completeness->edges[3].segment.start, Eigen::Vector3d(30.0, 0.0, 8.0));
  EXPECT_FALSE(read.completeness->edges[6].is_shown);
  EXPECT_EQ(read.completeness->rows[0].ci95->low, written.completeness->rows[0].ci95->low);
}

TEST(CompletenessJson, RefusesOtherJson) {
  Evaluation written = results_with(0.1).evaluations[0];
  written.completeness = three_of_four_ridges();
  nlohmann::json json = nlohmann::json::parse(to_json(written));
  json["completeness"]["rows"][0]["n_found"] = 5;
  EXPECT_THROW((void)parse_evaluation(json.dump()), std::invalid_argument);
  json["completeness"] = 3;
  EXPECT_THROW((void)parse_evaluation(json.dump()), std::invalid_argument);
}

TEST(CompletenessTables, HaveARowPerKindAndLength) {
  const std::vector<Evaluation> all = with_completeness().evaluations;
  const std::string csv = completeness_to_csv(all);
  EXPECT_THAT(csv, HasSubstr("\n1,joint,ridge,all,4,3,0.750000,"));
  EXPECT_THAT(csv, HasSubstr(",4,20.000,12.500,0.625000,0,60,7,lines,12345.0\n"));
  EXPECT_THAT(csv, HasSubstr("\n1,joint,eave,4-8,2,1,"));
  EXPECT_THAT(completeness_to_markdown(all[0]),
              AllOf(HasSubstr("7 of 60 lines follow no edge"), HasSubstr("1.23 ha"),
                    HasSubstr("1 further edges are shown in fewer than two images")));
  EXPECT_THAT(completeness_to_terminal(all), HasSubstr("62.5"));
}

TEST(CompletenessTables, AreEmptyWithoutFigures) {
  const std::vector<Evaluation> none = results_with(0.1).evaluations;
  EXPECT_EQ(completeness_to_markdown(none[0]), "");
  EXPECT_EQ(completeness_to_terminal(none), "");
}

}  // namespace
}  // namespace ridgeline::evaluate
