// SPDX-License-Identifier: BSD-3-Clause
// Which edges of the scan the lines show: the files, the report, gates and areas.
#include "tests/cli/cli_fixture.h"
#include "tests/support/csv_rows.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ridgeline::cli {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class CompletenessOfLines : public Cli {
 protected:
  /// Judges a line file with --completeness into `out`.
  [[nodiscard]] ProgramResult compare(const std::string& lines,
                                      const std::string& out,
                                      std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--completeness", "--decoys", "0"});
    return evaluate(lines, out, more);
  }

  [[nodiscard]] json completeness_in(const std::string& evaluation) const {
    return read_json(path(evaluation)).at("completeness");
  }

  /// The row of a kind in all lengths.
  static json row_of(const json& completeness, const std::string& kind) {
    for (const json& row : completeness.at("rows")) {
      if (row["kind"] == kind && row["length"] == "all") return row;
    }
    return nullptr;
  }

  /// The true lines of the scene without those of a kind.
  void write_truth_without(const std::string& kind, const std::string& file) const {
    json lines = read_json(path("scene/truth.geojson"));
    json kept = json::array();
    for (const json& line : lines["features"])
      if (line["properties"]["kind"] != kind) kept.push_back(line);
    lines["features"] = std::move(kept);
    write(path(file), lines.dump());
  }
};

TEST_F(CompletenessOfLines, OfTrueLinesIsHigh) {
  const ProgramResult result = compare("scene/truth.geojson", "out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("Edges of the scan that the lines have found"));
  const json found = completeness_in("out/evaluation.truth.json");
  EXPECT_EQ(found["area_from"], "lines");
  const json ridges = row_of(found, "ridge");
  EXPECT_GE(ridges["n"], 3);
  EXPECT_GE(ridges["recall"], 0.9);
  EXPECT_GE(row_of(found, "all")["recall"], 0.85);
  for (const char* file : {"completeness.csv", "accuracy.truth.md"})
    EXPECT_THAT(read(path("out") / file), HasSubstr("ridge")) << file;
  const json shown = data_of("out/report.html")["patches"][0]["methods"][0]["completeness"];
  EXPECT_EQ(shown["rows"], found["rows"]);
  EXPECT_FALSE(shown.contains("edges"));
}

TEST_F(CompletenessOfLines, LacksTheKindThatTheLinesLack) {
  write_truth_without("ridge", "no_ridges.geojson");
  const ProgramResult result = compare("no_ridges.geojson", "out", {"--no-report"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json found = completeness_in("out/evaluation.no_ridges.json");
  EXPECT_LE(row_of(found, "ridge")["recall"], 0.1);
  EXPECT_GE(row_of(found, "eave")["recall"], 0.8);
  write(path("gates.yaml"),
        "gates:\n"
        "  - {metric: scan_recall, kind: eave, min: 0.8}\n"
        "  - {metric: scan_recall_length, kind: ridge, min: 0.5}\n");
  const ProgramResult gated = run({"gate", "out", "--gates", "gates.yaml"});
  EXPECT_EQ(gated.exit_code, 3);
  EXPECT_THAT(gated.out, AllOf(HasSubstr("scan_recall eave"), HasSubstr("passed"),
                               HasSubstr("scan_recall_length ridge"), HasSubstr("failed")));
}

TEST_F(CompletenessOfLines, IsNotComputedByDefault) {
  ASSERT_EQ(compare("scene/lines.good.geojson", "out", {"--no-report"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("out/completeness.csv")));
  const ProgramResult result =
      evaluate("scene/lines.good.geojson", "out", {"--decoys", "0", "--no-report"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_FALSE(std::filesystem::exists(path("out/completeness.csv")));
  for (const char* file : {"evaluation.lines.good.json", "accuracy.lines.good.md", "run.json"})
    EXPECT_THAT(read(path("out") / file),
                AllOf(Not(HasSubstr("completeness\"")), Not(HasSubstr("edges of the scan"))))
        << file;
  write(path("gates.yaml"), "gates:\n  - {metric: scan_recall, min: 0.5}\n");
  const ProgramResult gated = run({"gate", "out", "--gates", "gates.yaml"});
  EXPECT_EQ(gated.exit_code, 3);
  EXPECT_THAT(gated.out, HasSubstr("were not compared with the edges of the scan"));
}

TEST_F(CompletenessOfLines, OfTwoAreasIsThatOfOne) {
  const std::string kLines = "scene/lines.good.geojson";
  ASSERT_EQ(compare(kLines, "whole", {"--no-report", "--area", "512000,5402000,514000,5404000"})
                .exit_code,
            0);
  ASSERT_EQ(
      compare(kLines, "west", {"--no-report", "--area", "512000,5402000,513031,5404000"}).exit_code,
      0);
  ASSERT_EQ(
      compare(kLines, "east", {"--no-report", "--area", "513031,5402000,514000,5404000"}).exit_code,
      0);
  const ProgramResult pooled = run({"pool", "west", "east", "--out", "pooled", "--no-report"});
  ASSERT_EQ(pooled.exit_code, 0) << pooled.err;
  EXPECT_EQ(read(path("pooled/completeness.csv")), read(path("whole/completeness.csv")));
  const auto n_edges = [&](const std::string& folder) {
    return completeness_in(folder + "/evaluation.lines.good.json")["edges"].size();
  };
  EXPECT_GT(n_edges("west"), 0U);
  EXPECT_GT(n_edges("east"), 0U);
  EXPECT_EQ(n_edges("west") + n_edges("east"), n_edges("whole"));
}

class CompletenessOfARun : public SmallPatch {};

TEST_F(CompletenessOfARun, IsOfTheGroundThatTheFirstImageShows) {
  const std::vector<std::string> words{"run", "patch/patch.yaml", "--out", "out", "--decoys",
                                       "0",   "--resume"};
  std::vector<std::string> with = words;
  with.emplace_back("--completeness");
  const ProgramResult result = run(with);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("Edges of the scan that the lines have found"));
  const json found = read_json(path("out/1/evaluation.lines.json"))["completeness"];
  EXPECT_EQ(found["area_from"], "images");
  EXPECT_GT(found["edges"].size(), 0U);
  EXPECT_FALSE(test::read_csv(path("out/completeness.csv")).empty());
  // the stage `evaluate` depends on the option
  ASSERT_EQ(run(words).exit_code, 0);
  EXPECT_FALSE(read_json(path("out/1/evaluation.lines.json")).contains("completeness"));
  EXPECT_FALSE(std::filesystem::exists(path("out/completeness.csv")));
}

}  // namespace
}  // namespace ridgeline::cli
