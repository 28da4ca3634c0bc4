// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/cli_fixture.h"

#include <map>
#include <set>
#include <sstream>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;

/// Files hold millimetres; a shift by whole metres changes none of them. What is left is the
/// rounding of doubles at 5.4e6 m, 1e-9 m.
constexpr double kShiftToleranceM = 1e-6;

class Evaluate : public Cli {
 protected:
  [[nodiscard]] nlohmann::json judged(const std::string& out) const {
    return read_json(path(out) / "evaluation.lines.good.json");
  }
};

std::vector<std::string> keys_of(const nlohmann::json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

TEST_F(Evaluate, WritesTheFilesOfTheContract) {
  const ProgramResult result = evaluate("scene/lines.good.geojson", "out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(names_in(path("out")),
              IsSupersetOf({"evaluation.lines.good.json", "evaluation.lines.good.csv",
                            "judged.lines.good.gpkg", "run.json", "table2.csv", "table2.json",
                            "table2.md", "table2.tex"}));
  const std::string table = read(path("out/table2.md"));
  EXPECT_THAT(result.out,
              AllOf(StartsWith("Distances of the lines from LIDAR planes, m\n"),
                    HasSubstr("Map for QGIS: out/judged.lines.good.gpkg\n"),
                    HasSubstr("Tables: out/table2.md\n"), HasSubstr("Report: out/report.html\n")));
  EXPECT_THAT(table, AllOf(HasSubstr("not_aligned"), HasSubstr("| lidar |")));
}

TEST_F(Evaluate, LeavesNoTemporaryFile) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "out").exit_code, 0);
  const std::set<std::string> known{".json", ".csv", ".md",   ".tex",
                                    ".html", ".png", ".gpkg", ".xml"};
  for (const std::string& name : names_in(path("out"))) {
    EXPECT_TRUE(known.contains(std::filesystem::path(name).extension())) << name;
  }
}

TEST_F(Evaluate, JudgesEachLineFileAndTheirCommonLines) {
  const ProgramResult result =
      run({"evaluate", "--lines", "scene/lines.good.geojson", "scene/lines.poor.geojson", "--cloud",
           "scene/lidar.las", "--out", "out"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(names_in(path("out")),
              IsSupersetOf({"evaluation.lines.good.json", "evaluation.lines.poor.json",
                            "table2.common.csv", "table2.common.md"}));
  const auto rms_m = [&](const char* name) {
    return read_json(path("out") / name)["summary"]["total"]["rms_m"].get<double>();
  };
  EXPECT_LT(rms_m("evaluation.lines.good.json"), rms_m("evaluation.lines.poor.json"));
}

TEST_F(Evaluate, Table2HasTheColumnsAndClassesOfTheContract) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "out").exit_code, 0);
  std::istringstream table(read(path("out/table2.csv")));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line,
            "patch,method,class,n_lines,n_evaluated,rms_m,ci95_low_m,ci95_high_m,median_m,nmad_m,"
            "q95_m,n_plan_images,rms_plan_images_m,n_points_place,rms_points_place_m");
  std::vector<std::string> rows;
  while (std::getline(table, line)) rows.push_back(line);
  EXPECT_THAT(rows, ElementsAre(StartsWith("lidar,lines.good,not_aligned,"),
                                StartsWith("lidar,lines.good,aligned,"),
                                StartsWith("lidar,lines.good,total,")));
}

TEST_F(Evaluate, EvaluationHasTheKeysOfTheContract) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "out").exit_code, 0);
  const nlohmann::json evaluation = judged("out");
  for (const auto& [name, summary] : evaluation["summary"].items()) {
    EXPECT_THAT(keys_of(summary),
                IsSupersetOf({"n_lines", "n_evaluated", "n_excluded", "rms_m", "ci95_m", "mean_m",
                              "median_m", "nmad_m", "q95_m", "max_m", "gross_share"}))
        << name;
  }
  ASSERT_FALSE(evaluation["lines"].empty());
  for (const auto& line : evaluation["lines"]) {
    EXPECT_THAT(keys_of(line), IsSupersetOf({"id", "class", "status", "kind", "planes",
                                             "mean_distance_m", "max_distance_m", "signed_mean_m"}))
        << line;
    for (const auto& plane : line["planes"]) {
      EXPECT_THAT(keys_of(plane), IsSupersetOf({"normal", "d", "n_inliers", "rms_m", "coverage"}));
    }
  }
}

TEST_F(Evaluate, StatusesSumToTheLines) {
  ASSERT_EQ(evaluate("scene/lines.poor.geojson", "out").exit_code, 0);
  const nlohmann::json evaluation = read_json(path("out/evaluation.lines.poor.json"));
  const std::size_t n_true_lines = read_json(path("scene/lines.poor.geojson"))["features"].size();
  EXPECT_EQ(evaluation["lines"].size(), n_true_lines);
  std::map<std::string, std::size_t> n_by_class;
  for (const auto& [name, summary] : evaluation["summary"].items()) {
    std::size_t n = summary["n_evaluated"];
    for (const auto& [reason, excluded] : summary["n_excluded"].items()) {
      n += excluded.get<std::size_t>();
    }
    EXPECT_EQ(n, summary["n_lines"].get<std::size_t>()) << name;
    n_by_class[name] = n;
  }
  EXPECT_EQ(n_by_class.at("total"), n_true_lines);
  EXPECT_EQ(n_by_class.at("aligned") + n_by_class.at("not_aligned"), n_true_lines);
}

TEST_F(Evaluate, OutputDoesNotDependOnTheThreads) {
  ASSERT_EQ(evaluate("scene/lines.fair.geojson", "one", {"--jobs", "1"}).exit_code, 0);
  ASSERT_EQ(evaluate("scene/lines.fair.geojson", "two", {"--jobs", "2"}).exit_code, 0);
  EXPECT_EQ(names_in(path("one")), names_in(path("two")));
  for (const std::string& name : names_in(path("one"))) {
    if (name == "run.json") continue;  // it holds times and memory
    EXPECT_TRUE(read(path("one") / name) == read(path("two") / name)) << name;
  }
}

TEST_F(Evaluate, FiguresDoNotDependOnTheOrigin) {
  const auto evaluate_at = [&](const std::string& origin, const std::string& name) {
    const ProgramResult simulated = run({"simulate", "--out", name, "--no-images", "--seed", "3",
                                         "--extent-m", "60,60", "--origin-m", origin});
    EXPECT_EQ(simulated.exit_code, 0) << simulated.err;
    const ProgramResult result = run({"evaluate", "--lines", name + "/lines.good.geojson",
                                      "--cloud", name + "/lidar.las", "--out", name + "/out"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return judged(name + "/out")["lines"];
  };
  const nlohmann::json near = evaluate_at("0,0,0", "near");
  const nlohmann::json far = evaluate_at("513000,5403000,250", "far");
  ASSERT_EQ(near.size(), far.size());
  ASSERT_FALSE(near.empty());
  for (std::size_t i = 0; i < near.size(); ++i) {
    EXPECT_EQ(near[i]["status"], far[i]["status"]) << i;
    if (near[i]["status"] != "evaluated") continue;
    EXPECT_NEAR(near[i]["mean_distance_m"].get<double>(), far[i]["mean_distance_m"].get<double>(),
                kShiftToleranceM)
        << i;
  }
}

TEST_F(Evaluate, LinesThatAreNoLinesGetAStatus) {
  write(path("odd.csv"),
        "id,x1,y1,z1,x2,y2,z2\n"
        "nan,nan,5403010,255,513010,5403010,255\n"
        "zero,513010,5403010,255,513010,5403010,255\n"
        "fine,513010,5403010,250,513014,5403010,250\n");
  const ProgramResult result = evaluate("odd.csv", "out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("odd.csv: 1 of 3 lines have non-finite coordinates"));
  const nlohmann::json lines = read_json(path("out/evaluation.odd.json"))["lines"];
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0]["id"], "nan");
  EXPECT_EQ(lines[0]["status"], "non_finite");
  EXPECT_EQ(lines[1]["id"], "zero");
  EXPECT_EQ(lines[1]["status"], "degenerate");
  EXPECT_EQ(lines[2]["class"], "all");
}

TEST_F(Evaluate, RunRecordNamesTheInputsByTheirHash) {
  ASSERT_EQ(evaluate("scene/lines.good.geojson", "out").exit_code, 0);
  const nlohmann::json record = read_json(path("out/run.json"));
  EXPECT_THAT(keys_of(record), IsSupersetOf({"versions", "options", "inputs", "stages", "seconds",
                                             "peak_memory_mib"}));
  EXPECT_EQ(record["options"]["judge"]["sample_consensus"], "msac");
  const ProgramResult sums = test::run_program(
      "/usr/bin/sha256sum", {"scene/lines.good.geojson", "scene/lidar.las"}, path("."));
  ASSERT_EQ(record["inputs"].size(), 2U);
  for (const auto& input : record["inputs"]) {
    EXPECT_THAT(sums.out, HasSubstr(input["sha256"].get<std::string>() + "  " +
                                    input["path"].get<std::string>()));
  }
}

TEST_F(Evaluate, JudgesAFolderOfLimapTracks) {
  for (const char* k : {"0", "1", "2"}) {
    write(path("tracks/track_" + std::string(k) + ".txt"),
          "513010 540301" + std::string(k) +
              " 250 513014 5403010 250\n2 2\nimage_id_list 4 9\nline_id_list 0 1\nline2d_list\n"
              "1 2 3 4\n1 2 3 4\nEND\n");
  }
  const ProgramResult result = evaluate("tracks", "out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read_json(path("out/evaluation.tracks.json"))["lines"].size(), 3U);
  EXPECT_EQ(read_json(path("out/run.json"))["inputs"].size(), 4U);
}

TEST_F(Evaluate, PatchClassesLinesAndNamesTheCloud) {
  nlohmann::json lines = read_json(path("scene/lines.good.geojson"));
  for (auto& feature : lines["features"]) {
    feature["properties"].erase("class");
    feature["properties"].erase("epipolar_angle_deg");
  }
  write(path("plain.geojson"), lines.dump());
  write(path("patch.yaml"),
        "id: north\nheight_range: [240, 270]\nlidar: [scene/lidar.las]\nimages:\n"
        "  - {id: left, path: l.tif, projection_matrix: "
        "[[1000, 0, -512, -512614400], [0, -1000, -512, 5403409600], [0, 0, -1, 800]]}\n"
        "  - {id: right, path: r.tif, projection_matrix: "
        "[[1000, 0, -512, -512664400], [0, -1000, -512, 5403409600], [0, 0, -1, 800]]}\n");
  write(path("config.yaml"), "reconstruct: {max_aligned_angle_deg: 30}\n");
  const std::vector<std::string> common{
      "evaluate", "--lines", "plain.geojson", "--patch", "patch.yaml", "--out", "out"};
  const auto expect_classes_up_to = [&](double angle_deg, const std::vector<std::string>& more) {
    std::vector<std::string> words = common;
    words.insert(words.end(), more.begin(), more.end());
    const ProgramResult result = run(words);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_THAT(read(path("out/table2.csv")),
                AllOf(HasSubstr("north,plain,aligned,"), HasSubstr("north,plain,not_aligned,")));
    const nlohmann::json evaluation = read_json(path("out/evaluation.plain.json"));
    for (const auto& line : evaluation["lines"]) {
      const bool aligned = line["epipolar_angle_deg"].get<double>() <= angle_deg;
      EXPECT_EQ(line["class"], aligned ? "aligned" : "not_aligned") << line["id"];
    }
  };
  expect_classes_up_to(10.0, {});
  expect_classes_up_to(30.0, {"--config", "config.yaml"});
  expect_classes_up_to(60.0, {"--config", "config.yaml", "--max-aligned-angle-deg", "60"});
}

TEST_F(Evaluate, NeverWritesOverAnInput) {
  write(path("out/table2.csv"), "id,x1,y1,z1,x2,y2,z2\n0,513010,5403010,250,513014,5403010,250\n");
  const std::string before = read(path("out/table2.csv"));
  EXPECT_REFUSED(evaluate("out/table2.csv", "out"),
                 AllOf(HasSubstr("out/table2.csv"), HasSubstr("would be overwritten")));
  EXPECT_EQ(read(path("out/table2.csv")), before);
  std::filesystem::create_directory_symlink("out", path("alias"));
  EXPECT_REFUSED(evaluate("out/table2.csv", "alias"), HasSubstr("would be overwritten"));
  EXPECT_EQ(read(path("out/table2.csv")), before);
}

}  // namespace
}  // namespace ridgeline::cli
