// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <cstdlib>
#include <sstream>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
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
  EXPECT_THAT(result.out, HasSubstr("Accuracy gate: passed"));
}

TEST_F(Gate, FailsWithExitCodeThreeAndTheNumbers) {
  const ProgramResult result = gate(kHard);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("Accuracy gate: failed"), HasSubstr("above the limit 0.001")));
}

TEST_F(Gate, MissingFigureFails) {
  EXPECT_EQ(gate("{class: roof, metric: rms_m, max: 10.0}").exit_code, 3);
  EXPECT_EQ(gate("{method: absent, metric: rms_m, max: 10.0}").exit_code, 3);
  EXPECT_EQ(gate("{patch: absent, metric: rms_m, max: 10.0}").exit_code, 3);
  EXPECT_EQ(gate("{metric: correctness, min: 0.0}").exit_code, 3);
}

TEST_F(Gate, ClassThatCannotExistSaysHowToGetIt) {
  nlohmann::json lines = read_json(path("scene/lines.good.geojson"));
  for (nlohmann::json& feature : lines["features"]) {
    feature["properties"].erase("class");
    feature["properties"].erase("epipolar_angle_deg");  // otherwise it gives a class
  }
  write(path("plain.geojson"), lines.dump());
  ASSERT_EQ(evaluate("plain.geojson", "results").exit_code, 0);
  EXPECT_EQ(gate(kEasy).exit_code, 0) << "lines without classes count in total";
  const ProgramResult result = gate("{class: aligned, metric: rms_m, max: 10.0}");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.out, AllOf(HasSubstr("no class aligned, only total"), HasSubstr("--patch"),
                                HasSubstr("column class")));
}

TEST_F(Gate, AppliesToEveryLineFileOfAnEvaluation) {
  ASSERT_EQ(run({"evaluate", "--lines", "scene/lines.good.geojson", "scene/lines.poor.geojson",
                 "--cloud", "scene/lidar.las", "--out", "results", "--no-report"})
                .exit_code,
            0);
  const std::string out = gate(kEasy).out;
  EXPECT_THAT(out, AllOf(HasSubstr("  lines.good  "), HasSubstr("  lines.poor  ")));
  EXPECT_THAT(gate("{metric: rms_m, max: 10.0, method: lines.poor}").out,
              Not(HasSubstr("lines.good")));
}

TEST_F(Gate, NumberOfLinesOfTheFileHoldsForEveryGateWithoutOne) {
  write(path("gates.yaml"),
        "n_min: 100000\ngates: [{max: 10.0}, {metric: median_m, max: 10.0, n_min: 1}]\n");
  const ProgramResult result = run({"gate", "results", "--gates", "gates.yaml"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.out, AllOf(HasSubstr("1 of 2 checks passed"),
                                HasSubstr("rms_m <= 10 (n >= 100000)"), HasSubstr("insufficient")));
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

TEST_F(Gate, BaselineThatNoGateRefersToHoldsNothingAndSaysSo) {
  const ProgramResult result =
      gate("{metric: evaluated_share, min: 0.0}", {"--baseline", "results"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("1 of 1 checks passed"));
  EXPECT_THAT(result.err, HasSubstr("no gate refers to the baseline"));
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

/// The names of all test cases with their class names.
std::string testcases(const std::filesystem::path& file) {
  boost::property_tree::ptree xml;
  read_xml(file.string(), xml);
  std::string names;
  for (const auto& [name, node] : xml.get_child("testsuites.testsuite")) {
    if (name != "testcase") continue;
    names += node.get<std::string>("<xmlattr>.classname") + ": " +
             node.get<std::string>("<xmlattr>.name") + "\n";
  }
  return names;
}

TEST_F(Gate, JunitNamesThePatchOfAPatternAfterItsFolder) {
  const auto names_for = [&](const std::vector<std::string>& clouds) {
    std::vector<std::string> arguments{"evaluate", "--lines", "scene/lines.good.geojson",
                                       "--out",    "results", "--no-report",
                                       "--cloud"};
    arguments.insert(arguments.end(), clouds.begin(), clouds.end());
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(gate(kEasy, {"--junit", "gate.xml", "--overwrite"}).exit_code, 0);
    return testcases(path("gate.xml"));
  };
  const std::string current = path("").parent_path().filename().string();
  EXPECT_THAT(names_for({"scene/*.las"}),
              AllOf(HasSubstr("ridgeline.gate.scene.lines_good: total rms_m <= 10"),
                    HasSubstr("(patch scene, lines.good)")));
  EXPECT_THAT(names_for({"./scene/lidar.las"}), HasSubstr("(patch lidar, lines.good)"));
  EXPECT_THAT(names_for({"*/lidar.la?"}), HasSubstr("(patch " + current + ", lines.good)"));
  std::filesystem::copy(path("scene/lidar.las"), path("scene/again.las"));
  EXPECT_THAT(names_for({"scene/lidar.las", "scene/again.las"}),
              HasSubstr("(patch scene, lines.good)"));
  std::filesystem::copy(path("scene/lidar.las"), path("lidar.v2.las"));
  EXPECT_THAT(names_for({"./*.las"}), HasSubstr("(patch " + current + ", lines.good)"));
  EXPECT_THAT(names_for({"lidar.v2.las"}),
              HasSubstr("ridgeline.gate.lidar_v2.lines_good: total rms_m <= 10 (patch lidar.v2,"));
}

TEST_F(Gate, SummaryAndJsonTellTheVerdict) {
  const ProgramResult result =
      gate(std::string(kEasy) + ", " + kHard, {"--summary", "s.md", "--json", "g.json"});
  ASSERT_EQ(result.exit_code, 3);
  EXPECT_THAT(read(path("s.md")),
              AllOf(HasSubstr("Accuracy gate: **failed**"), HasSubstr("total rms_m \\<= 10 |")));
  EXPECT_THAT(result.out, AllOf(HasSubstr("total rms_m <= 10 "), Not(HasSubstr("\\"))));
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
                 AllOf(HasSubstr("gates.yaml: line 1"), HasSubstr("unknown key 'metrc'"),
                       HasSubstr("did you mean 'metric'?"),
                       HasSubstr("known keys: patch, method, class, metric")));
  EXPECT_REFUSED(gate("{metric: nope_m, max: 0.3}"),
                 AllOf(HasSubstr("gates.yaml: line 1"), HasSubstr("nope_m"),
                       HasSubstr("evaluated_share"), HasSubstr("completeness")));
  EXPECT_REFUSED(gate("{metric: evaluated_share, min: 80}"),
                 AllOf(HasSubstr("gates.yaml: line 1: min: 80"), HasSubstr("must be 0 to 1")));
  EXPECT_REFUSED(gate("{class: aligned, metric: quality, min: 0.8}"), HasSubstr("no classes"));
  EXPECT_REFUSED(gate("{decided_by: images, max: 0.3}"),
                 AllOf(HasSubstr("gates.yaml: line 1: decided_by = images"),
                       HasSubstr("must be plan_images or points_place")));
  EXPECT_REFUSED(gate("{max: [0.3]}"), HasSubstr("must be a finite number"));
  EXPECT_REFUSED(gate("{metric: rms_m}"), HasSubstr("gates.yaml"));
  EXPECT_REFUSED(gate(""), HasSubstr("gates.yaml"));
  EXPECT_REFUSED(gate("{a: ["), AllOf(HasSubstr("gates.yaml"), HasSubstr("not YAML")));
  EXPECT_REFUSED(run({"gate", "results", "--gates", "no.yaml"}), HasSubstr("no.yaml"));
}

TEST_F(Gate, InitPrintsAFileThatExplainsEveryKeyAndMetric) {
  const ProgramResult printed = run({"gate", "--init"});
  ASSERT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_EQ(printed.err, "");
  const std::string unknown_key = gate("{metrc: rms_m}").err;
  const std::string unknown_metric = gate("{metric: none, max: 0.3}").err;
  for (const char* key : {"known keys: ", "must be one of "}) {
    const std::string& message = *key == 'k' ? unknown_key : unknown_metric;
    std::istringstream list(message.substr(message.find(key) + std::string(key).size()));
    int n_names = 0;
    for (std::string name; list >> name; ++n_names) {
      if (name.ends_with(',')) name.pop_back();
      EXPECT_THAT(printed.out, ContainsRegex("\n#   " + name)) << "is not explained";
    }
    EXPECT_GT(n_names, 10) << message;
  }
  write(path("gates.yaml"), printed.out);
  EXPECT_EQ(run({"gate", "results", "--gates", "gates.yaml"}).exit_code, 0);
  EXPECT_THAT(run({"gate", "--help"}).out, HasSubstr("--init"));
}

TEST_F(Gate, InitWritesANewFileAndNeverOverOne) {
  EXPECT_EQ(run({"gate", "--init", "new/gates.yaml"}).exit_code, 0);
  EXPECT_EQ(read(path("new/gates.yaml")), run({"gate", "--init"}).out);
  write(path("mine.yaml"), "mine");
  EXPECT_REFUSED(run({"gate", "--init", "mine.yaml"}), HasSubstr("mine.yaml: already exists"));
  EXPECT_EQ(read(path("mine.yaml")), "mine");
  EXPECT_REFUSED(run({"gate", "--init", "scene"}), HasSubstr("scene: already exists"));
  EXPECT_REFUSED(run({"gate", "--init", "new.yaml", "--gates", "mine.yaml"}), HasSubstr("--init"));
}

TEST_F(Gate, MissingArgumentIsNamedWithTheWayToStart) {
  EXPECT_REFUSED(run({"gate"}), AllOf(HasSubstr("RESULTS is missing"), HasSubstr("gate --init")));
  EXPECT_REFUSED(run({"gate", "results"}), HasSubstr("--gates is missing"));
}

TEST_F(Gate, FolderWithoutResultsIsRefused) {
  write(path("gates.yaml"), std::string("gates: [") + kEasy + "]\n");
  EXPECT_REFUSED(run({"gate", "none", "--gates", "gates.yaml"}),
                 HasSubstr("none: is not a results folder"));
  EXPECT_REFUSED(run({"gate", "scene", "--gates", "gates.yaml"}),
                 HasSubstr("scene: holds no evaluation.*.json"));
  EXPECT_REFUSED(gate(kEasy, {"--baseline", "none"}), HasSubstr("none: is not a results folder"));
}

TEST_F(Gate, DamagedResultsAreRefusedByName) {
  write(path("results/run.json"), "{}");
  EXPECT_REFUSED(gate(kEasy), AllOf(HasSubstr("results/run.json"), HasSubstr("inputs")));
  write(path("results/table2.json"), R"({"passed": true, "gates": []})");
  EXPECT_REFUSED(gate(kEasy),
                 AllOf(HasSubstr("results/table2.json"), HasSubstr("is not a Table 2")));
  std::filesystem::remove(path("results/table2.json"));
  write(path("results/evaluation.lines.good.json"), "{");
  EXPECT_REFUSED(gate(kEasy), HasSubstr("results/evaluation.lines.good.json: not JSON"));
}

TEST_F(Gate, ReportsNeverLandOnAnInput) {
  EXPECT_REFUSED(gate(kEasy, {"--junit", "gates.yaml"}), HasSubstr("would be overwritten"));
  EXPECT_THAT(read(path("gates.yaml")), HasSubstr("gates: ["));
  EXPECT_REFUSED(gate(kEasy, {"--json", "results/run.json"}), HasSubstr("would be overwritten"));
  EXPECT_REFUSED(gate(kEasy, {"--json", "results/table2.json"}), HasSubstr("would be overwritten"));
  EXPECT_REFUSED(gate(kEasy, {"--junit", "same", "--summary", "same"}),
                 HasSubstr("would be overwritten"));
  EXPECT_REFUSED(gate(kEasy, {"--summary", "scene"}), HasSubstr("scene: is a folder"));
}

}  // namespace
}  // namespace ridgeline::cli
