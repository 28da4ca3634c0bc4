// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <cstdlib>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class Gate : public Cli {
 protected:
  void SetUp() override {
    ASSERT_EQ(evaluate("scene/lines.good.geojson", "results").exit_code, 0);
    ASSERT_EQ(evaluate("scene/lines.poor.geojson", "poor").exit_code, 0);
  }

  /// Applies the entries, e.g. "{metric: rms_m, max: 0.3}", to a folder of results.
  [[nodiscard]] ProgramResult gate(const std::string& entries,
                                   const std::vector<std::string>& more = {}) const {
    write(path("gates.yaml"), "gates: [" + entries + "]\n");
    std::vector<std::string> arguments{"gate", "results", "--gates", "gates.yaml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

constexpr const char* kEasy = "{class: total, metric: rms_m, max: 10.0}";
constexpr const char* kHard = "{class: total, metric: rms_m, max: 0.001}";

TEST_F(Gate, PassesWithExitCodeZero) {
  const ProgramResult result = gate(kEasy);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("**passed**"));
}

TEST_F(Gate, FailsWithExitCodeThreeAndTheNumbers) {
  const ProgramResult result = gate(kHard);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.out, AllOf(HasSubstr("**failed**"), HasSubstr("above the limit 0.001")));
}

TEST_F(Gate, MissingFigureFails) {
  EXPECT_EQ(gate("{class: roof, metric: rms_m, max: 10.0}").exit_code, 3);
  EXPECT_EQ(gate("{method: absent, metric: rms_m, max: 10.0}").exit_code, 3);
  EXPECT_EQ(gate("{patch: absent, metric: rms_m, max: 10.0}").exit_code, 3);
  EXPECT_EQ(gate("{metric: correctness, min: 0.0}").exit_code, 3);
}

TEST_F(Gate, TooFewLinesFail) {
  const ProgramResult result = gate("{class: total, metric: rms_m, max: 10.0, n_min: 100000}");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.out, HasSubstr("insufficient"));
}

TEST_F(Gate, RatioComparesTheClasses) {
  const std::string entry =
      "{class: total, metric: rms_m, max_ratio_to: {class: not_aligned}, n_min: 1, ratio: ";
  EXPECT_EQ(gate(entry + "2.5}").exit_code, 0);
  EXPECT_EQ(gate(entry + "0.1}").exit_code, 3);
}

TEST_F(Gate, BaselineRuleFailsWithoutABaselineAndPassesAgainstItself) {
  const std::string entry = "{metric: rms_m, max_increase_over_baseline: 0.02}";
  EXPECT_EQ(gate(entry).exit_code, 3);
  EXPECT_EQ(gate(entry, {"--baseline", "results"}).exit_code, 0);
}

TEST_F(Gate, WorseThanTheBaselineFails) {
  std::filesystem::create_directory(path("worse"));
  std::filesystem::copy(path("scene/lines.poor.geojson"), path("worse/lines.good.geojson"));
  ASSERT_EQ(evaluate("worse/lines.good.geojson", "worse/out").exit_code, 0);
  write(path("gates.yaml"), "gates: [{metric: rms_m, max_increase_over_baseline: 0.02}]\n");
  const auto against = [&](const std::string& results, const std::string& baseline) {
    return run({"gate", results, "--gates", "gates.yaml", "--baseline", baseline}).exit_code;
  };
  EXPECT_EQ(against("worse/out", "results"), 3);
  EXPECT_EQ(against("results", "worse/out"), 0);
}

TEST_F(Gate, BaselineOfOtherDataIsRefused) {
  nlohmann::json record = read_json(path("poor/run.json"));
  for (auto& input : record["inputs"]) input["sha256"] = std::string(64, '0');
  write(path("poor/run.json"), record.dump());
  EXPECT_REFUSED(gate("{metric: rms_m, max_increase_over_baseline: 0.02}", {"--baseline", "poor"}),
                 HasSubstr("lidar.las"));
}

TEST_F(Gate, JunitIsWellFormedAndHoldsTheNumbers) {
  ASSERT_EQ(gate(std::string(kEasy) + ", " + kHard, {"--junit", "reports/gate.xml"}).exit_code, 3);
  boost::property_tree::ptree xml;
  ASSERT_NO_THROW(read_xml(path("reports/gate.xml").string(), xml));
  const auto& suite = xml.get_child("testsuites.testsuite");
  EXPECT_EQ(suite.get<int>("<xmlattr>.tests"), 2);
  EXPECT_EQ(suite.get<int>("<xmlattr>.failures"), 1);
  EXPECT_EQ(suite.count("testcase"), 2U);
  std::string body;
  for (const auto& [name, node] : suite) body += node.get<std::string>("failure", "");
  EXPECT_THAT(body, AllOf(HasSubstr("value: 0.0"), HasSubstr("limit: 0.0010"), HasSubstr("n: "),
                          HasSubstr("95 % interval: ")));
}

TEST_F(Gate, SummaryAndJsonTellTheVerdict) {
  const ProgramResult result =
      gate(std::string(kEasy) + ", " + kHard, {"--summary", "s.md", "--json", "g.json"});
  ASSERT_EQ(result.exit_code, 3);
  EXPECT_EQ(read(path("s.md")), result.out);
  const nlohmann::json json = read_json(path("g.json"));
  EXPECT_EQ(json["passed"], false);
  EXPECT_EQ(json["gates"].size(), 2U);
}

TEST_F(Gate, AnnotationsAppearOnGitHubOnly) {
  write(path("gates.yaml"), std::string("gates: [") + kHard + "]\n");
  const std::vector<std::string> arguments{"gate", "results", "--gates", "gates.yaml"};
  EXPECT_THAT(run(arguments, {"GITHUB_ACTIONS=true"}).out, HasSubstr("\n::error "));
  if (std::getenv("GITHUB_ACTIONS") == nullptr) {
    EXPECT_THAT(run(arguments).out, Not(HasSubstr("::error")));
  }
}

TEST_F(Gate, WrongGatesFileIsRefusedWithTheRule) {
  EXPECT_REFUSED(gate("{class: total, metrc: rms_m, max: 0.3}"),
                 AllOf(HasSubstr("gates.yaml: line 1"), HasSubstr("unknown key metrc"),
                       HasSubstr("known keys: patch, method, class, metric")));
  EXPECT_REFUSED(gate("{metric: nope_m, max: 0.3}"),
                 AllOf(HasSubstr("gates.yaml"), HasSubstr("nope_m"), HasSubstr("evaluated_share")));
  EXPECT_REFUSED(gate("{metric: rms_m}"), HasSubstr("gates.yaml"));
  EXPECT_REFUSED(gate(""), HasSubstr("gates.yaml"));
  EXPECT_REFUSED(gate("{a: ["), AllOf(HasSubstr("gates.yaml"), HasSubstr("not YAML")));
  EXPECT_REFUSED(run({"gate", "results", "--gates", "no.yaml"}), HasSubstr("no.yaml"));
}

TEST_F(Gate, FolderWithoutResultsIsRefused) {
  write(path("gates.yaml"), std::string("gates: [") + kEasy + "]\n");
  EXPECT_REFUSED(run({"gate", "none", "--gates", "gates.yaml"}),
                 HasSubstr("none: is no folder of results"));
  EXPECT_REFUSED(run({"gate", "scene", "--gates", "gates.yaml"}),
                 HasSubstr("scene: holds no evaluation.*.json"));
  EXPECT_REFUSED(gate(kEasy, {"--baseline", "none"}), HasSubstr("none: is no folder of results"));
}

TEST_F(Gate, DamagedResultsAreRefusedByName) {
  write(path("results/run.json"), "{}");
  EXPECT_REFUSED(gate(kEasy), AllOf(HasSubstr("results/run.json"), HasSubstr("inputs")));
  write(path("results/table2.json"), R"({"passed": true, "gates": []})");
  EXPECT_REFUSED(gate(kEasy), AllOf(HasSubstr("results/table2.json"), HasSubstr("is no Table 2")));
  std::filesystem::remove(path("results/table2.json"));
  write(path("results/evaluation.lines.good.json"), "{");
  EXPECT_REFUSED(gate(kEasy), HasSubstr("results/evaluation.lines.good.json: not JSON"));
}

TEST_F(Gate, ReportsNeverLandOnAnInput) {
  EXPECT_REFUSED(gate(kEasy, {"--junit", "gates.yaml"}), HasSubstr("would be written over"));
  EXPECT_THAT(read(path("gates.yaml")), HasSubstr("gates: ["));
  EXPECT_REFUSED(gate(kEasy, {"--json", "results/run.json"}), HasSubstr("would be written over"));
  EXPECT_REFUSED(gate(kEasy, {"--json", "results/table2.json"}),
                 HasSubstr("would be written over"));
  EXPECT_REFUSED(gate(kEasy, {"--junit", "same", "--summary", "same"}),
                 HasSubstr("would be written over"));
  EXPECT_REFUSED(gate(kEasy, {"--summary", "scene"}), HasSubstr("scene: is a folder"));
}

}  // namespace
}  // namespace ridgeline::cli
