// SPDX-License-Identifier: BSD-3-Clause
// What the README says of gates holds as printed: its gates file on the demonstration and on a
// worsened copy of it. tests/action runs its CI job.
#include "tests/cli/run_fixture.h"
#include "tests/support/paths.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// The YAML code block of the README's section on gates that has this key on top.
std::string readme_block(const std::string& key) {
  const std::string readme = read(fs::path(test::source_dir()) / "README.md");
  const std::string section = readme.substr(readme.find("\n## Accuracy gates in CI\n") + 1);
  const std::string text = section.substr(0, section.find("\n## "));
  const std::string fence = "\n```yaml\n";
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at + 1)) {
    const std::size_t begin = at + fence.size();
    std::string block = text.substr(begin, text.find("\n```\n", begin) + 1 - begin);
    if (YAML::Load(block)[key]) return block;
  }
  ADD_FAILURE() << "the README's section on gates has no code block with the key " << key;
  return "";
}

/// The method that a gate without one applies to.
std::string product_in(const fs::path& patch_folder) {
  for (const char* method : {"lines", "network", "joint", "direct"}) {
    if (fs::exists(patch_folder / fmt::format("evaluation.{}.json", method))) return method;
  }
  ADD_FAILURE() << patch_folder << " has no evaluation";
  return "";
}

class ReadmeGate : public Cli {
 protected:
  /// Moves the lines of a patch by half a metre and evaluates them again in place of what was
  /// there.
  void worsen(const std::string& results, const std::string& patch_id) const {
    constexpr double kShift_m = 0.5;  // far above 0.30 m, the limit in the README
    const fs::path folder = path(results) / patch_id;
    const std::string method = product_in(folder);
    nlohmann::json lines = read_json(folder / fmt::format("lines.{}.geojson", method));
    for (nlohmann::json& feature : lines["features"]) {
      if (feature["geometry"].is_null()) continue;
      for (nlohmann::json& vertex : feature["geometry"]["coordinates"]) {
        vertex[2] = vertex[2].get<double>() + kShift_m;
      }
    }
    const std::string moved = fmt::format("moved/{}.geojson", method);
    write(path(moved), lines.dump());
    const fs::path patch = fs::path(test::source_dir()) / "sample_data" / patch_id / "patch.yaml";
    const ProgramResult again = run({"evaluate", "--lines", moved, "--patch", patch.string(),
                                     "--out", "moved/results", "--no-report"});
    ASSERT_EQ(again.exit_code, 0) << again.err;
    const std::string evaluation = fmt::format("evaluation.{}.json", method);
    fs::copy_file(path("moved/results") / evaluation, folder / evaluation,
                  fs::copy_options::overwrite_existing);
  }

  [[nodiscard]] ProgramResult gate(const std::string& results,
                                   const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"gate", results, "--gates", "gates.yaml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /// Runs the sample patches of two images. No line of a patch of crossing strips is aligned.
  void run_pairs() const {
    std::vector<std::string> words{"run", "--out", "pairs", "--no-report"};
    for (const char* patch : {"1", "2", "3"})
      words.push_back(fs::path(test::source_dir()) / "sample_data" / patch / "patch.yaml");
    const ProgramResult result = run(words);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
};

TEST_F(ReadmeGate, FilePassesOnTheSamplePairsAndFailsOnAWorsenedCopy) {
  run_pairs();
  write(path("gates.yaml"), readme_block("gates"));
  const ProgramResult passed = gate("pairs");
  EXPECT_EQ(passed.exit_code, 0) << passed.out << passed.err;
  fs::copy(path("pairs"), path("worse"), fs::copy_options::recursive);
  worsen("worse", "2");
  const ProgramResult failed = gate("worse");
  EXPECT_EQ(failed.exit_code, 3) << failed.out << failed.err;
  EXPECT_THAT(failed.out, HasSubstr("above the limit 0.3"));
}

/// Every metric that the program lists for one that it does not know.
std::vector<std::string> listed_metrics(const std::string& message) {
  const std::string list = message.substr(message.find("must be one of ") + 15);
  std::vector<std::string> metrics;
  const std::regex word("[a-z0-9_]+");
  for (std::sregex_iterator it(list.begin(), list.end(), word), end; it != end; ++it) {
    metrics.push_back(it->str());
  }
  return metrics;
}

/// A gates file with one gate a metric, whose limits depend on its unit.
std::string gates_of(const std::vector<std::string>& metrics,
                     const char* limits_of_metres,
                     const char* limits_of_shares) {
  std::string gates = "gates:\n";
  for (const std::string& metric : metrics) {
    gates += fmt::format("  - {{metric: {}, {}}}\n", metric,
                         metric.ends_with("_m") ? limits_of_metres : limits_of_shares);
  }
  return gates;
}

class ListedMetrics : public RunSample {
 protected:
  /// Metrics of the gates that fail.
  [[nodiscard]] std::set<std::string> failed(const std::string& results,
                                             const std::string& gates) const {
    write(path("gates.yaml"), gates);
    const ProgramResult result =
        run({"gate", results, "--gates", "gates.yaml", "--json", "verdicts.json", "--overwrite"});
    std::set<std::string> metrics;
    const nlohmann::json verdicts = read_json(path("verdicts.json"));
    for (const auto& gate : verdicts["gates"]) {
      if (gate["verdict"] != "passed") metrics.insert(gate["metric"]);
    }
    EXPECT_EQ(result.exit_code, metrics.empty() ? 0 : 3) << result.out << result.err;
    return metrics;
  }
};

TEST_F(ListedMetrics, WorkOnARunOrSayWhyNot) {
  ASSERT_EQ(run_patch("out", {"--no-report"}).exit_code, 0);
  write(path("gates.yaml"), "gates: [{metric: none, max: 1}]");
  std::vector<std::string> metrics =
      listed_metrics(run({"gate", "out", "--gates", "gates.yaml"}).err);
  EXPECT_EQ(std::erase(metrics, "buildings_within_m"), 1U);  // needs within_m and buildings
  EXPECT_EQ(std::erase(metrics, "decoy_share"), 1U);         // needs kind and distance_m
  ASSERT_THAT(metrics, testing::IsSupersetOf({"rms_m", "evaluated_share_by_length", "quality"}));
  const std::string wide = gates_of(metrics, "min: -10, max: 10", "min: 0, max: 1");
  // Sample 1 has no reference tracks, and --completeness was not given.
  EXPECT_THAT(failed("out", wide), testing::UnorderedElementsAre(
                                       "edge_recall", "observation_recall", "observation_precision",
                                       "scan_recall", "scan_recall_length"));
  EXPECT_THAT(read(path("verdicts.json")),
              testing::AllOf(HasSubstr("reference_tracks"), HasSubstr("`completeness`")));
  EXPECT_EQ(failed("out", gates_of(metrics, "min: 50", "min: 1, max: 0")),
            std::set<std::string>(metrics.begin(), metrics.end()));

  ASSERT_EQ(evaluate("scene/lines.good.geojson", "judged").exit_code, 0);
  EXPECT_THAT(failed("judged", wide),
              testing::UnorderedElementsAre("correctness", "completeness", "quality", "edge_recall",
                                            "observation_recall", "observation_precision",
                                            "scan_recall", "scan_recall_length"));
  EXPECT_THAT(read(path("verdicts.json")), HasSubstr("evaluate does not"));
}

/// The template with the gates that it proposes in comments in force.
std::string uncommented(const std::string& text) {
  return std::regex_replace(text, std::regex("\n  # - "), "\n  - ");
}

TEST_F(ReadmeGate, TemplatePassesOnTheSamplePairsWithAllThatItProposes) {
  run_pairs();
  const ProgramResult printed = run({"gate", "--init"});
  ASSERT_EQ(printed.exit_code, 0) << printed.err;
  write(path("gates.yaml"), printed.out);
  EXPECT_EQ(gate("pairs").exit_code, 0) << gate("pairs").out;
  write(path("gates.yaml"), uncommented(printed.out));
  EXPECT_EQ(gate("pairs").exit_code, 3) << "no baseline given";
  const ProgramResult all = gate("pairs", {"--baseline", "pairs"});
  EXPECT_EQ(all.exit_code, 0) << all.out << all.err;
  EXPECT_THAT(all.out, AllOf(HasSubstr("quality >= 0.85"), HasSubstr("baseline + 0.02"),
                             HasSubstr("<= 2.5 x not_aligned"), HasSubstr("(n >= 20)")));
}

}  // namespace
}  // namespace ridgeline::cli
