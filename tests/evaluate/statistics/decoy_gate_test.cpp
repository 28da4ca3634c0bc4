// SPDX-License-Identifier: BSD-3-Clause
// Gates on the share of decoys that pass, and gates that ask for the upper end of an interval.
#include "evaluate/gates/gate_report.h"
#include "tests/evaluate/statistics/gate_scene.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Gate decoy_gate(double max) {
  Gate gate;
  gate.metric = "decoy_share";
  gate.kind = "height";
  gate.distance_m = 1.0;
  gate.max = max;
  return gate;
}

ResultFolder with_decoys(std::size_t n_passed, std::size_t n_decoys, Interval ci95) {
  ResultFolder folder = results_with(0.1);
  folder.evaluations[0].decoys = {{.kind = DecoyKind::kHeight,
                                   .distance_m = 1.0,
                                   .n_lines = n_decoys,
                                   .n_decoys = n_decoys,
                                   .n_passed = n_passed,
                                   .n_withheld = n_decoys / 4,
                                   .n_clusters = 12,
                                   .ci95 = ci95}};
  return folder;
}

/// What validate() says of a gate.
std::string refusal(const Gate& gate) {
  try {
    validate(gate);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(DecoyGate, ComparesTheShareOfItsKindAndDistance) {
  const ResultFolder folder = with_decoys(4, 400, {0.002, 0.02});
  const GateResult passed = only_result(decoy_gate(0.02), folder);
  EXPECT_EQ(passed.verdict, Verdict::kPassed);
  EXPECT_EQ(passed.value, 0.01);
  EXPECT_EQ(passed.n, 400U);
  EXPECT_EQ(passed.evaluated_share, 0.75);
  EXPECT_EQ(passed.rule, "decoy_share height 1 m <= 0.02");
  EXPECT_EQ(only_result(decoy_gate(0.02), with_decoys(10, 400, {0.018, 0.036})).verdict,
            Verdict::kFailed);
}

TEST(DecoyGate, WithAnIntervalWiderThanItsLimitIsInsufficient) {
  const GateResult result = only_result(decoy_gate(0.02), with_decoys(0, 100, {0.0, 0.037}));
  EXPECT_EQ(result.verdict, Verdict::kInsufficient);
  EXPECT_THAT(result.explanation, HasSubstr("0 to 0.037, is wider than the limit 0.02"));
}

TEST(DecoyGate, FailsWhereNoLineWasMovedSo) {
  EXPECT_EQ(only_result(decoy_gate(0.02), results_with(0.1)).verdict, Verdict::kMissing);
  Gate other = decoy_gate(0.02);
  other.distance_m = 5.0;
  EXPECT_EQ(only_result(other, with_decoys(0, 400, {0.0, 0.01})).verdict, Verdict::kMissing);
}

TEST(DecoyGate, NeedsKindAndDistanceWhichNoOtherMetricTakes) {
  EXPECT_EQ(refusal(decoy_gate(0.02)), "");
  Gate gate = decoy_gate(0.02);
  gate.kind = "sideways";
  EXPECT_THAT(refusal(gate), HasSubstr("kind: sideways"));
  gate.kind.reset();
  EXPECT_THAT(refusal(gate), HasSubstr("kind: none"));
  gate = decoy_gate(0.02);
  gate.distance_m = 3.0;
  EXPECT_THAT(refusal(gate), AllOf(HasSubstr("distance_m: 3"), HasSubstr("0.5, 1, 2, 5")));
  gate = decoy_gate(0.02);
  gate.line_class = "aligned";
  EXPECT_THAT(refusal(gate), HasSubstr("class: aligned"));
  gate = gate_on("total");
  gate.max = 0.3;
  gate.distance_m = 1.0;
  EXPECT_THAT(refusal(gate), HasSubstr("distance_m: rms_m does not use it"));
}

/// Results with an RMS of 0.1 m, whose interval ends at 0.15 m and rests on so many clusters.
ResultFolder with_interval(std::size_t n_clusters) {
  ResultFolder folder = results_with(0.1);
  for (Summary& cell : folder.evaluations[0].classes) {
    cell.ci95_m = Interval{0.08, 0.15};
    cell.n_clusters = n_clusters;
  }
  return folder;
}

TEST(UpperBound, IsComparedInPlaceOfThePoint) {
  Gate gate = gate_on("total");
  gate.max = 0.12;
  EXPECT_EQ(only_result(gate, with_interval(20)).verdict, Verdict::kPassed);
  gate.bound = GateBound::kUpper95;
  const GateResult failed = only_result(gate, with_interval(20));
  EXPECT_EQ(failed.verdict, Verdict::kFailed);
  EXPECT_EQ(failed.rule, "total rms_m upper95 <= 0.12");
  EXPECT_THAT(failed.explanation, HasSubstr("0.15 is above the limit 0.12"));
  gate.max = 0.15;
  EXPECT_EQ(only_result(gate, with_interval(20)).verdict, Verdict::kPassed);
}

TEST(UpperBound, OfFewerThanTenClustersIsInsufficient) {
  Gate gate = gate_on("total");
  gate.max = 0.2;
  gate.bound = GateBound::kUpper95;
  EXPECT_EQ(only_result(gate, with_interval(10)).verdict, Verdict::kPassed);
  const GateResult result = only_result(gate, with_interval(9));
  EXPECT_EQ(result.verdict, Verdict::kInsufficient);
  EXPECT_THAT(result.explanation, HasSubstr("9 clusters, at least 10"));
}

TEST(UpperBound, IsForMaxOfMetricsWithAClusteredInterval) {
  Gate gate = gate_on("total");
  gate.bound = GateBound::kUpper95;
  gate.min = 0.1;
  EXPECT_THAT(refusal(gate), HasSubstr("only for max, so min"));
  gate = gate_on("total", "median_m");
  gate.max = 0.1;
  gate.bound = GateBound::kUpper95;
  EXPECT_THAT(refusal(gate), HasSubstr("median_m has no clustered interval"));
  gate.metric = "correctness";
  EXPECT_THAT(refusal(gate), HasSubstr("correctness has no clustered interval"));
}

TEST(UpperBound, StandsInTheBodyOfAFailure) {
  Gate gate = gate_on("total");
  gate.max = 0.12;
  gate.bound = GateBound::kUpper95;
  const GateReport report = apply_gates(std::vector{gate}, with_interval(20));
  EXPECT_THAT(to_junit(report, "2026-01-01T00:00:00"),
              AllOf(HasSubstr("value: 0.1000"), HasSubstr("95 % interval: 0.0800 - 0.1500"),
                    HasSubstr("clusters: 20"), HasSubstr("bound: upper95")));
  EXPECT_EQ(nlohmann::json::parse(to_json(report))["gates"][0]["bound"], "upper95");
}

}  // namespace
}  // namespace ridgeline::evaluate
