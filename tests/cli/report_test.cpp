// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/read_cloud.h"
#include "tests/cli/cli_fixture.h"

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// The small patch, run into `out/`.
class Report : public SmallPatch {
 protected:
  void run_patch(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"run", "patch/patch.yaml", "--out",
                                       "out", "--methods",        "direct,joint"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult result = run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.err;
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

TEST_F(Report, ShowsTheSurfaceThatTheRunKept) {
  run_patch();
  const nlohmann::json patch = data_of("out/report.html")["patches"].at(0);
  const nlohmann::json& surface = patch["surface"];
  const io::PointCloud kept = io::read_cloud({path("out/1/surface.las").string()}, {});
  ASSERT_EQ(surface["n_shown"], kept.points.size());
  EXPECT_EQ(surface["positions"].get_ref<const std::string&>().size(), 8 * kept.points.size());
  // in plan the surface lies where the LIDAR points lie
  for (std::size_t axis = 0; axis < 2; ++axis) {
    constexpr double kBorder_m = 25.0;  // either may reach this much farther
    const double low_m = surface["low"][axis];
    EXPECT_NEAR(low_m, patch["points"]["low"][axis].get<double>(), kBorder_m);
  }
}

TEST_F(Report, ShowsNoSurfaceOfARunWithoutOne) {
  run_patch({"--preset", "published"});
  const nlohmann::json patch = data_of("out/report.html")["patches"].at(0);
  EXPECT_TRUE(patch["surface"].is_null());
  EXPECT_TRUE(patch["notes"].empty()) << patch["notes"];
}

TEST_F(Report, SaysThatTheSurfaceIsGoneOrHasChanged) {
  run_patch({"--no-report"});
  const auto patch = [&] {
    EXPECT_EQ(run({"report", "out"}).exit_code, 0);
    return data_of("out/report.html")["patches"].at(0);
  };
  const std::string las = read(path("out/1/surface.las"));
  write(path("out/1/surface.las"), las.substr(0, las.size() - 30));
  EXPECT_THAT(patch()["notes"].dump(), HasSubstr("points of the surface are not shown: "
                                                 "1/surface.las: has changed since the run"));
  fs::remove(path("out/1/surface.las"));
  const nlohmann::json without = patch();
  EXPECT_TRUE(without["surface"].is_null());
  EXPECT_THAT(without["notes"].dump(), HasSubstr("1/surface.las: no longer exists"));
}

TEST_F(Report, VerdictsOfTheMatchesAddUpToTable1) {
  run_patch();
  const nlohmann::json data = data_of("out/report.html");
  std::map<std::string, int> n;
  for (const auto& match : data["patches"][0]["images"]["pairs"][0]["matches"])
    ++n[match["verdict"]];
  const nlohmann::json row = data["table1"].at(0);
  EXPECT_EQ(n["correct"], row["correct"]);
  EXPECT_EQ(n["false"], row["false"]);
  EXPECT_EQ(n["unjudged"], row["unjudged"]);
  EXPECT_EQ(data["patches"][0]["images"]["pairs"][0]["missed"].size(), row["missed"]);
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
  const std::string folder = path("").string();
  std::vector<std::string> arguments{"evaluate"};
  const std::vector<std::pair<std::string, std::string>> files{
      {"--lines", "patch/lines.good.geojson"},
      {"--cloud", "patch/lidar.las"},
      {"--patch", "patch/patch.yaml"},
      {"--out", "judged"}};
  for (const auto& [flag, file] : files) {
    arguments.push_back(flag);
    arguments.push_back(path(file).string());
  }
  arguments.emplace_back("--no-report");
  ASSERT_EQ(run(arguments).exit_code, 0);
  fs::remove(path("patch/lidar.las"));
  fs::remove(path("patch/left.tif"));
  ASSERT_EQ(run({"report", path("judged").string()}).exit_code, 0);
  const nlohmann::json data = data_of("judged/report.html");
  EXPECT_EQ(data["run"]["options"]["lines"].at(0), "lines.good.geojson");
  EXPECT_THAT(data["patches"][0]["notes"].dump(), HasSubstr("lidar.las: no longer exists"));
  EXPECT_THAT(data.dump(), Not(HasSubstr(folder)));
}

TEST_F(Report, ShowsTheLastEvaluationOnly) {
  ASSERT_EQ(evaluate("scene/lines.poor.geojson", "judged").exit_code, 0);
  fs::copy(path("scene/lidar.las"), path("scene/town.las"));
  ASSERT_EQ(run({"evaluate", "--lines", "scene/lines.good.geojson", "--cloud", "scene/town.las",
                 "--out", "judged", "--no-report"})
                .exit_code,
            0);
  write(path("judged/evaluation.old.json"), "cut sho");
  write(path("judged/table1.json"), R"({"rows": [{"patch": "1"}]})");
  const ProgramResult result = run({"report", "judged"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json data = data_of("judged/report.html");
  ASSERT_EQ(data["patches"].size(), 1U);
  EXPECT_EQ(data["patches"][0]["id"], "town");
  ASSERT_EQ(data["patches"][0]["methods"].size(), 1U);
  EXPECT_EQ(data["patches"][0]["methods"][0]["name"], "lines.good");
  EXPECT_TRUE(data["table1"].empty());
}

TEST_F(Report, OfARunIsNotDisturbedByAnEvaluationInItsPatch) {
  run_patch({"--no-report"});
  EXPECT_REFUSED(evaluate("scene/lines.good.geojson", "out/1", {"--no-report"}),
                 HasSubstr("out/1/to_fix.csv"));
  fs::remove(path("out/1/to_fix.csv"));
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "out/1", {"--no-report"}).exit_code, 0);
  const ProgramResult result = run({"report", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json data = data_of("out/report.html");
  ASSERT_EQ(data["patches"].size(), 1U);
  EXPECT_EQ(data["patches"][0]["id"], "1");
  EXPECT_EQ(data["patches"][0]["methods"].size(), 2U);
  EXPECT_FALSE(data["patches"][0]["images"].is_null());
}

TEST_F(Report, OfJudgedFilesDrawsTheFilesGiven) {
  fs::create_directories(path("judged"));
  fs::copy(path("scene/lines.poor.geojson"), path("judged/lines.lines.good.geojson"));
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "judged").exit_code, 0);
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "fresh").exit_code, 0);
  EXPECT_EQ(data_of("judged/report.html")["patches"], data_of("fresh/report.html")["patches"]);
}

TEST_F(Report, LinesInFeetStandAmongThePoints) {
  const ProgramResult result =
      evaluate("scene/truth.geojson", "judged", {"--assume-crs", "EPSG:2263"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json patch = data_of("judged/report.html")["patches"].at(0);
  ASSERT_FALSE(patch["points"].is_null()) << patch["notes"];
  const nlohmann::json& lines = patch["methods"].at(0)["lines"];
  ASSERT_FALSE(lines.empty());
  for (const auto& line : lines) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double low_m = patch["points"]["low"][axis];
      const double step_m = patch["points"]["step"][axis];
      EXPECT_GT(line["start"][axis], low_m - 10.0);
      EXPECT_LT(line["start"][axis], low_m + 65535 * step_m + 10.0);
    }
  }
  // only the surroundings of lines were read, which give no share of the area
  EXPECT_TRUE(patch["points"]["no_data_share"].is_null());
}

TEST_F(Report, WithoutAReportTheResultsOfARunStand) {
  fs::create_directories(path("out/report.html/in_the_way"));
  const ProgramResult result =
      run({"run", "patch/patch.yaml", "--out", "out", "--methods", "direct"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("the report could not be written"));
  EXPECT_THAT(names_in(path("out")), IsSupersetOf({"run.json", "table2.md"}));
  EXPECT_REFUSED(run({"report", "out"}), HasSubstr("report.html"));
}

TEST_F(Report, OfAnEarlierRunDoesNotStayBesideNewResults) {
  const std::vector<std::string> arguments{"run", "patch/patch.yaml", "--out",
                                           "out", "--methods",        "direct"};
  ASSERT_EQ(run(arguments).exit_code, 0);
  ASSERT_TRUE(fs::exists(path("out/report.html")));
  for (const fs::directory_entry& entry : fs::directory_iterator(path("out"))) {
    if (!entry.is_directory()) continue;
    fs::remove(entry.path() / "fig1.png");
    fs::create_directories(entry.path() / "fig1.png" / "in_the_way");
  }
  const ProgramResult again = run(arguments);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("the report could not be written"));
  EXPECT_FALSE(fs::exists(path("out/report.html")));
}

TEST_F(Report, PairsOfNoSegmentAreAFaultOfTheReference) {
  write(path("patch/matches.csv"), "left_id,right_id\n0,0\n5000,0\n");
  EXPECT_REFUSED(run({"run", "patch/patch.yaml", "--out", "out"}),
                 AllOf(HasSubstr("matches.csv"), HasSubstr("left_id = 5000, must be in 0..")));
}

TEST_F(Report, AnotherPatchFilesChangeHidesNothing) {
  fs::copy(path("patch"), path("other"));
  std::string yaml = read(path("other/patch.yaml"));
  yaml.replace(yaml.find("\"1\""), 3, "\"2\"");
  write(path("other/patch.yaml"), yaml);
  ASSERT_EQ(run({"run", "patch/patch.yaml", "other/patch.yaml", "--out", "out", "--methods",
                 "direct", "--no-report"})
                .exit_code,
            0);
  write(path("patch/patch.yaml"), "id: changed");
  ASSERT_EQ(run({"report", "out"}).exit_code, 0);
  const nlohmann::json patches = data_of("out/report.html")["patches"];
  EXPECT_THAT(patches.at(0)["notes"].dump(), HasSubstr("has changed since the run"));
  EXPECT_FALSE(patches.at(1)["images"].is_null());
  EXPECT_TRUE(patches.at(1)["notes"].empty()) << patches.at(1)["notes"];
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
  EXPECT_REFUSED(run({"report", "nowhere"}), HasSubstr("is not a results folder"));
  write(path("empty/evaluation.x.json"), "[]");
  EXPECT_REFUSED(run({"report", "empty"}), HasSubstr("evaluation.x.json"));
  write(path("empty/evaluation.x.json"), R"({"method": "x", "lines": [{}]})");
  EXPECT_REFUSED(run({"report", "empty"}),
                 HasSubstr("evaluation.x.json: evaluation: no key patch"));
}

TEST_F(Report, RefusesResultsOfTheWrongTypes) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "out", {"--no-report"}).exit_code, 0);
  const std::string file = "out/evaluation.lines.good.json";
  const nlohmann::json good = read_json(path(file));
  nlohmann::json bad = good;
  bad["lines"][0]["planes"][0]["id"] = {1, 2};
  write(path(file), bad.dump());
  EXPECT_REFUSED(run({"report", "out"}), HasSubstr("lines.good.json: line 0: id: [1,2]"));
  write(path(file), good.dump());
  nlohmann::json record = read_json(path("out/run.json"));
  record["options"]["patch"] = 7;
  write(path("out/run.json"), record.dump());
  EXPECT_REFUSED(run({"report", "out"}), HasSubstr("out: a results file is damaged"));
}

TEST_F(Report, FiguresAreThoseOfTheLines) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "out", {"--no-report"}).exit_code, 0);
  const std::string file = "out/evaluation.lines.good.json";
  const nlohmann::json good = read_json(path(file));
  nlohmann::json changed = good;
  changed["summary"]["total"] = 7;
  write(path(file), changed.dump());
  ASSERT_EQ(run({"report", "out"}).exit_code, 0);
  const nlohmann::json method = data_of("out/report.html")["patches"].at(0)["methods"].at(0);
  for (const char* key : {"summary", "accuracy", "standards", "calibration", "strata"}) {
    EXPECT_EQ(method[key], good[key]) << key;
  }
}

}  // namespace
}  // namespace ridgeline::cli
