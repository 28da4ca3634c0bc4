// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// Sample patch 1 in `patch/`, run into `out/`.
class Report : public Cli {
 protected:
  Report() { fs::copy(fs::path(RIDGELINE_SOURCE_DIR) / "sample_data/1", path("patch")); }

  void run_patch(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"run", "patch/patch.yaml", "--out", "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult result = run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }

  /// The data that the page shows.
  [[nodiscard]] nlohmann::json data_of(const std::string& report) const {
    const std::string page = read(path(report));
    const std::string open = "id=\"report-data\">";
    const std::size_t begin = page.find(open) + open.size();
    return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  }
};

TEST_F(Report, RunWritesThePageAndTheFiguresOfThePaper) {
  run_patch();
  EXPECT_THAT(names_in(path("out")), Contains("report.html"));
  EXPECT_THAT(names_in(path("out/1")), IsSupersetOf({"fig1.png", "fig7.left.png", "fig7.right.png",
                                                     "fig8.direct.png", "fig8.joint.png"}));
}

TEST_F(Report, ShowsTheFiguresOfTheResultFiles) {
  run_patch();
  const nlohmann::json data = data_of("out/report.html");
  EXPECT_EQ(data["table1"], read_json(path("out/table1.json"))["rows"]);
  EXPECT_EQ(data["table2"], read_json(path("out/table2.json"))["rows"]);
  const nlohmann::json& patch = data["patches"].at(0);
  const nlohmann::json direct = read_json(path("out/1/evaluation.direct.json"));
  EXPECT_EQ(patch["methods"].at(0)["summary"], direct["summary"]);
  ASSERT_EQ(patch["methods"].at(0)["lines"].size(), direct["lines"].size());
  for (std::size_t i = 0; i < direct["lines"].size(); ++i) {
    EXPECT_EQ(patch["methods"][0]["lines"][i]["mean_distance_m"],
              direct["lines"][i]["mean_distance_m"]);
  }
  EXPECT_TRUE(patch["notes"].empty()) << patch["notes"];
  EXPECT_EQ(patch["points"]["n_all"], patch["points"]["n_shown"]);
}

TEST_F(Report, VerdictsOfTheMatchesAddUpToTable1) {
  run_patch();
  const nlohmann::json data = data_of("out/report.html");
  std::map<std::string, int> n;
  for (const auto& match : data["patches"][0]["images"]["matches"]) ++n[match["verdict"]];
  const nlohmann::json row = data["table1"].at(0);
  EXPECT_EQ(n["correct"], row["correct"]);
  EXPECT_EQ(n["false"], row["false"]);
  EXPECT_EQ(n["unjudged"], row["unjudged"]);
  EXPECT_EQ(data["patches"][0]["images"]["missed"].size(), row["missed"]);
}

TEST_F(Report, MadeLaterHasTheSameBytes) {
  run_patch();
  const std::string page = read(path("out/report.html"));
  fs::remove(path("out/report.html"));
  const ProgramResult result = run({"report", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(read(path("out/report.html")) == page);
}

TEST_F(Report, HoldsNoFoldersOfTheSender) {
  run_patch();
  EXPECT_THAT(data_of("out/report.html")["run"].dump(), Not(HasSubstr(path("patch").string())));
}

TEST_F(Report, CanBeLeftOut) {
  run_patch({"--no-report"});
  EXPECT_THAT(names_in(path("out")), Not(Contains("report.html")));
  EXPECT_THAT(names_in(path("out/1")), Not(Contains("fig1.png")));
}

TEST_F(Report, SaysWhatHasChangedOrIsGone) {
  run_patch({"--no-report"});
  fs::remove(path("patch/lidar.las"));
  write(path("patch/truth.geojson"), "{}");
  ASSERT_EQ(run({"report", "out"}).exit_code, 0);
  const nlohmann::json patch = data_of("out/report.html")["patches"].at(0);
  EXPECT_TRUE(patch["points"].is_null());
  EXPECT_FALSE(patch["images"].is_null());
  EXPECT_THAT(patch["notes"].dump(),
              AllOf(HasSubstr("lidar.las"), HasSubstr("truth.geojson"),
                    HasSubstr("has changed since the run"), Not(HasSubstr("patch/lidar.las"))));
}

TEST_F(Report, ShowsTheVerdictOfGates) {
  run_patch({"--no-report"});
  write(path("gates.yaml"), "gates:\n  - {class: total, metric: rms_m, max: 0.001}\n");
  ASSERT_EQ(run({"report", "out", "--gates", "gates.yaml"}).exit_code, 0);
  EXPECT_FALSE(data_of("out/report.html")["gates"]["passed"]);
}

TEST_F(Report, OfJudgedLineFilesNeedsNoImages) {
  const ProgramResult result = evaluate("scene/lines.good.geojson", "judged");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json patch = data_of("judged/report.html")["patches"].at(0);
  EXPECT_TRUE(patch["images"].is_null());
  EXPECT_FALSE(patch["points"].is_null());
  EXPECT_THAT(names_in(path("judged")), Contains("fig8.lines.good.png"));
}

TEST_F(Report, RefusesAFolderWithoutResults) {
  fs::create_directories(path("empty"));
  EXPECT_REFUSED(run({"report", "empty"}), HasSubstr("holds no evaluation"));
  EXPECT_REFUSED(run({"report", "nowhere"}), HasSubstr("is no folder"));
  write(path("empty/evaluation.x.json"), "[]");
  EXPECT_REFUSED(run({"report", "empty"}), HasSubstr("evaluation.x.json"));
  write(path("empty/evaluation.x.json"), R"({"method": "x", "lines": [{}]})");
  EXPECT_REFUSED(run({"report", "empty"}), HasSubstr("is no evaluation"));
}

}  // namespace
}  // namespace ridgeline::cli
