// SPDX-License-Identifier: BSD-3-Clause
#include "io/sha256.h"
#include "tests/cli/cli_fixture.h"

#include <algorithm>
#include <map>
#include <set>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// A copy of sample patch 1 in `patch/`.
class RunPatch : public Cli {
 protected:
  RunPatch() { fs::copy(fs::path(RIDGELINE_SOURCE_DIR) / "sample_data/1", path("patch")); }

  [[nodiscard]] ProgramResult run_patch(const std::string& out,
                                        const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"run", "patch/patch.yaml", "--out", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /// Replaces what stands in the patch file; a failure if it does not stand there.
  void edit_patch(std::string_view from, std::string_view to) const {
    std::string text = read(path("patch/patch.yaml"));
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from << " is not in " << text;
    write(path("patch/patch.yaml"), text.replace(at, from.size(), to));
  }
  /// Takes a key and what hangs on it out of the patch file.
  void remove_line(std::string_view key) const {
    const std::string text = read(path("patch/patch.yaml"));
    const std::size_t begin = text.find(std::string(key) + ":");
    ASSERT_NE(begin, std::string::npos) << key;
    std::string rest = text.substr(text.find('\n', begin) + 1);
    while (rest.starts_with(" ") || rest.starts_with("-")) rest.erase(0, rest.find('\n') + 1);
    write(path("patch/patch.yaml"), text.substr(0, begin) + rest);
  }

  /// Hashes of all files of a result folder but the run's record, by relative name.
  [[nodiscard]] std::map<std::string, std::string> results_in(const std::string& folder) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(path(folder))) {
      if (!entry.is_regular_file() || entry.path().filename() == "run.json") continue;
      files[fs::relative(entry.path(), path(folder)).string()] =
          io::sha256_of_file(entry.path().string());
    }
    return files;
  }
};

TEST_F(RunPatch, WritesTheFilesOfTheContractAndPrintsBothTables) {
  const ProgramResult result = run_patch("out", {"--lines-format", "csv,dxf"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(names_in(path("out")),
              IsSupersetOf({"1", "run.json", "table1.csv", "table1.json", "table1.md", "table2.csv",
                            "table2.json", "table2.md", "table2.tex"}));
  EXPECT_THAT(names_in(path("out/1")),
              IsSupersetOf({"evaluation.direct.json", "evaluation.joint.json", "lines.direct.csv",
                            "lines.direct.geojson", "lines.joint.dxf", "lines.joint.geojson",
                            "judged.joint.gpkg", "matches.csv", "segments.left.csv",
                            "segments.right.csv"}));
  EXPECT_THAT(result.out, AllOf(HasSubstr("Matches\n"), HasSubstr("Distances of the lines"),
                                HasSubstr("out/1/judged.joint.gpkg\n")));
  // RFC 7946: a feature without a place has no geometry
  EXPECT_THAT(read(path("out/1/lines.joint.geojson")),
              AllOf(HasSubstr("\"geometry\":null"), Not(HasSubstr("[null"))));
  EXPECT_THAT(read(path("out/1/matches.csv")),
              testing::StartsWith("left_id,right_id,score,votes,matcher\n"));
}

TEST_F(RunPatch, RegistersTheRightEdgesOfNotAlignedLinesUnlessToldNotTo) {
  ASSERT_EQ(run_patch("on").exit_code, 0);
  write(path("p.yaml"), "reconstruct: {register_profiles: false}\n");
  ASSERT_EQ(run_patch("off", {"--config", "p.yaml"}).exit_code, 0);
  for (const char* file : {"1/lines.direct.geojson", "1/lines.joint.geojson"}) {
    const auto on = read_json(path("on") / file).at("features");
    const auto off = read_json(path("off") / file).at("features");
    ASSERT_EQ(on.size(), off.size());
    std::size_t n_moved = 0;
    for (std::size_t i = 0; i < on.size(); ++i) {
      const auto& registered = on[i].at("properties");
      const auto& extracted = off[i].at("properties");
      if (registered.at("right_px") == extracted.at("right_px")) {
        EXPECT_EQ(on[i].at("geometry"), off[i].at("geometry")) << registered;
        continue;
      }
      ++n_moved;
      EXPECT_EQ(registered.at("class"), "not_aligned");
      EXPECT_NE(on[i].at("geometry"), off[i].at("geometry"));
    }
    EXPECT_GT(n_moved, 0U) << file;
  }
}

TEST_F(RunPatch, TwoMatchersGiveTheirListsAndOneOfBoth) {
  const ProgramResult result = run_patch("out", {"--matcher", "pairwise,chio"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(names_in(path("out/1")),
              IsSupersetOf({"matches.csv", "unmatched.csv", "verdicts.csv", "matches.pairwise.csv",
                            "unmatched.pairwise.csv", "verdicts.pairwise.csv", "matches.chio.csv",
                            "unmatched.chio.csv", "verdicts.chio.csv", "chio.csv"}));
  const std::string table1 = read(path("out/table1.csv"));
  EXPECT_THAT(table1,
              AllOf(HasSubstr("\n1,pairwise,"), HasSubstr("\n1,chio,"), HasSubstr("\n1,both,")));
  EXPECT_THAT(read(path("out/1/matches.csv")),
              AllOf(HasSubstr(",pairwise\n"), HasSubstr(",pairwise+chio\n")));
  EXPECT_THAT(read(path("out/1/unmatched.chio.csv")), HasSubstr("epipolar_degenerate"));
  // every line of chio tells how it was acquired
  EXPECT_THAT(read(path("out/1/chio.csv")),
              testing::StartsWith("left_id,right_id,linked_right_ids,process,neighbour_left_id,"
                                  "neighbour_height_m,height_limit_m,n_pieces,"));
  // lines come from the list of both
  const auto lines = read_json(path("out/1/lines.joint.geojson"))["features"];
  const std::string matches = read(path("out/1/matches.csv"));
  std::set<std::pair<std::string, std::string>> matched;  // several lines of one match among them
  for (const auto& line : lines) {
    matched.emplace(line["properties"]["left_id"], line["properties"]["right_id"]);
  }
  EXPECT_EQ(static_cast<std::ptrdiff_t>(matched.size()),
            std::count(matches.begin(), matches.end(), '\n') - 1);
  const ProgramResult again = run_patch("out", {"--matcher", "pairwise,chio", "--resume"});
  EXPECT_THAT(again.err, HasSubstr("6 finished stages skipped"));

  // lists of other matchers do not stay beside those of the next run
  ASSERT_EQ(run_patch("out", {"--no-report"}).exit_code, 0);
  for (const std::string& file : names_in(path("out/1"))) {
    EXPECT_THAT(file, Not(testing::AnyOf(HasSubstr("chio"), HasSubstr(".pairwise."))));
  }
}

TEST_F(RunPatch, RunsWithDifferentMatchersAreComparedByWhatTheyFind) {
  for (const char* matcher : {"pairwise", "chio", "pairwise,chio"}) {
    const std::string out =
        std::string("m/") + (std::string(matcher).size() > 8 ? "both" : matcher);
    ASSERT_EQ(
        run_patch(out, {"--matcher", matcher, "--no-report", "--methods", "direct"}).exit_code, 0);
  }
  const ProgramResult result = run({"compare", "m/pairwise", "m/chio", "m/both", "--out", "cmp"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("| 1 | pairwise | pairwise, by height |"),
                    HasSubstr("| 1 | chio | chio |"), HasSubstr("| 1 | both | both, by height |")));
  const auto rows = read_json(path("cmp/compare.json"))["rows"];
  ASSERT_EQ(rows.size(), 3U);
  // the list of both loses no match that pairwise has
  EXPECT_GE(rows[2]["correct"], rows[0]["correct"]);
  EXPECT_EQ(rows[0]["alone"], 0);

  // other segments have other ids
  write(path("p.yaml"), "extract: {min_length_px: 20}\n");
  ASSERT_EQ(run_patch("m/chio", {"--matcher", "chio", "--no-report", "--methods", "direct",
                                 "--config", "p.yaml"})
                .exit_code,
            0);
  EXPECT_REFUSED(run({"compare", "m/pairwise", "m/chio"}), HasSubstr("not the segments"));
}

TEST_F(RunPatch, WithoutPropagationPairwiseIsAlone) {
  write(path("p.yaml"), "match: {propagate_heights: false}\n");
  ASSERT_EQ(run_patch("out", {"--config", "p.yaml", "--no-report"}).exit_code, 0);
  EXPECT_THAT(read(path("out/1/matches.csv")), Not(HasSubstr("pairwise_height")));
  EXPECT_REFUSED(run_patch("out", {"--matcher", "other"}), HasSubstr("other"));
}

TEST_F(RunPatch, TheListOfBothMatchersTellsWhichMatchesCameByHeight) {
  ASSERT_EQ(run_patch("one", {"--no-report"}).exit_code, 0);
  ASSERT_EQ(run_patch("both", {"--no-report", "--matcher", "pairwise,chio"}).exit_code, 0);
  const auto count = [&](const char* file) {
    const std::string text = read(path(file));
    std::size_t n = 0;
    for (auto at = text.find("pairwise_height"); at != std::string::npos;
         at = text.find("pairwise_height", at + 1)) {
      ++n;
    }
    return n;
  };
  ASSERT_GT(count("one/1/matches.csv"), 0U);
  EXPECT_EQ(count("both/1/matches.csv"), count("one/1/matches.csv"));
}

TEST_F(RunPatch, MethodsDifferOnAlignedLinesOnlyUnlessFacesAdjustThem) {
  write(path("no_faces.yaml"), "reconstruct: {faces_beside: false}\n");
  ASSERT_EQ(run_patch("out", {"--config", "no_faces.yaml"}).exit_code, 0);
  const auto direct = read_json(path("out/1/lines.direct.geojson"));
  const auto joint = read_json(path("out/1/lines.joint.geojson"));
  std::map<std::string, nlohmann::json> joint_lines;
  for (const auto& j : joint["features"]) joint_lines[j["properties"]["id"]] = j;
  int n_changed = 0;
  int n_cut = 0;
  for (const auto& d : direct["features"]) {
    const std::string id = d["properties"]["id"];
    const bool is_cut = joint_lines.contains(id + ".1");  // a match that shows several lines
    EXPECT_NE(is_cut, joint_lines.contains(id)) << id;
    const nlohmann::json& j = joint_lines[is_cut ? id + ".1" : id];
    EXPECT_EQ(d["properties"]["left_id"], j["properties"]["left_id"]);
    const bool same = d["geometry"] == j["geometry"];
    EXPECT_TRUE(same || d["properties"]["class"] == "aligned") << id;
    n_changed += same ? 0 : 1;
    n_cut += is_cut ? 1 : 0;
  }
  EXPECT_GT(n_changed, 5);
  EXPECT_GT(n_cut, 0);

  ASSERT_EQ(run_patch("with_faces").exit_code, 0);
  int n_adjusted = 0;
  const auto with_faces = read_json(path("with_faces/1/lines.joint.geojson"));
  for (const auto& j : with_faces["features"]) {
    const bool same = j["geometry"] == joint_lines[j["properties"]["id"]]["geometry"];
    n_adjusted += !same && j["properties"]["class"] == "not_aligned" ? 1 : 0;
  }
  EXPECT_GT(n_adjusted, 20);
}

TEST_F(RunPatch, LinesOfPlanesAreCountedByThemselves) {
  // a pair whose lines would be those of the faces is left with few edges
  write(path("few.yaml"),
        "extract: {min_length_px: 60, faint_edges: false}\nmatch: {guided: false}\n");
  const std::vector<std::string> more{"--config", "few.yaml", "--no-report"};
  std::vector<std::string> with_planes = more;
  with_planes.insert(with_planes.end(), {"--methods", "direct,joint,planes"});
  ASSERT_EQ(run_patch("with", with_planes).exit_code, 0);
  ASSERT_EQ(run_patch("without", more).exit_code, 0);
  const nlohmann::json lines = read_json(path("with/1/lines.planes.geojson"))["features"];
  ASSERT_FALSE(lines.empty());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const nlohmann::json& properties = lines[i]["properties"];
    EXPECT_EQ(properties["id"], "p" + std::to_string(i));
    EXPECT_EQ(properties["status"], "planes");
    EXPECT_FALSE(properties.contains("left_id"));
    EXPECT_TRUE(properties.contains("covariance"));
  }
  EXPECT_THAT(read(path("with/table2.csv")), HasSubstr("\n1,planes,total,"));
  // the other methods, and the lines that they have in common, stay as they are
  for (const char* file : {"1/lines.joint.geojson", "table2.common.csv"})
    EXPECT_EQ(read(path(std::string("with/") + file)), read(path(std::string("without/") + file)));
  const ProgramResult published =
      run_patch("published", {"--preset", "published", "--methods", "joint,planes"});
  EXPECT_EQ(published.exit_code, 1);
  EXPECT_THAT(published.err, HasSubstr("planes is none of the papers' methods"));
}

TEST_F(RunPatch, ResumeSkipsWhatIsFinishedAndGivesTheSameBytes) {
  ASSERT_EQ(run_patch("out").exit_code, 0);
  const auto first = results_in("out");
  const ProgramResult again = run_patch("out", {"--resume"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("6 finished stages skipped"));
  EXPECT_EQ(results_in("out"), first);

  // a file that was touched is made again, and all that hangs on it stays, being the same
  write(path("out/1/lines.joint.geojson"), "damaged");
  const ProgramResult repaired = run_patch("out", {"--resume"});
  EXPECT_THAT(repaired.err, HasSubstr("5 finished stages skipped"));
  EXPECT_EQ(results_in("out"), first);

  for (const char* name : {"evaluation.joint.csv", "accuracy.joint.md"}) {
    fs::remove(path("out/1") / name);
    EXPECT_THAT(run_patch("out", {"--resume"}).err, HasSubstr("5 finished stages skipped")) << name;
    EXPECT_EQ(results_in("out"), first);
  }

  // another option of the matching leaves the extraction alone
  write(path("p.yaml"), "match: {min_probability: 0.9}\n");
  const ProgramResult other = run_patch("out", {"--resume", "--config", "p.yaml"});
  EXPECT_THAT(other.err, HasSubstr("1 finished stages skipped"));
}

TEST_F(RunPatch, InputsAreNeverWrittenOver) {
  const auto before = results_in("patch");
  fs::create_directory(path("in"));
  fs::rename(path("patch"), path("in/1"));
  EXPECT_REFUSED(run({"run", "in/1/patch.yaml", "--out", "in"}),
                 AllOf(HasSubstr("in/1/matches.csv"), HasSubstr("would be written over")));
  EXPECT_REFUSED(run({"reconstruct", "in/1/patch.yaml", "--out", "in/1/truth.geojson"}),
                 HasSubstr("would be written over"));
  EXPECT_EQ(results_in("in/1"), before);
}

TEST_F(RunPatch, MethodsOfAnEarlierRunAreNoResultsOfTheLast) {
  ASSERT_EQ(run_patch("out", {"--methods", "direct,network"}).exit_code, 0);
  ASSERT_EQ(run_patch("out", {"--methods", "direct,joint"}).exit_code, 0);
  write(path("gates.yaml"), "gates: [{method: network, metric: rms_m, max: 10.0}]\n");
  const ProgramResult result = run({"gate", "out", "--gates", "gates.yaml"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.out, HasSubstr("missing"));

  fs::remove(path("out/1/evaluation.joint.json"));
  for (const char* command : {"report", "compare"}) {
    EXPECT_REFUSED(run({command, "out"}), HasSubstr("names method joint of patch 1"));
  }
}

TEST_F(RunPatch, GatesHoldTheFiguresOfMatching) {
  ASSERT_EQ(run_patch("out", {"--no-report"}).exit_code, 0);
  const auto gate = [&](const std::string& entry) {
    write(path("gates.yaml"), "gates: [" + entry + "]\n");
    return run({"gate", "out", "--gates", "gates.yaml"}).exit_code;
  };
  EXPECT_EQ(gate("{metric: correctness, method: pairwise, min: 0.5}"), 0);
  EXPECT_EQ(gate("{metric: completeness, min: 0.5}"), 0);
  EXPECT_EQ(gate("{metric: quality, max: 0.1}"), 3);
  EXPECT_EQ(gate("{metric: quality, method: chio, min: 0.5}"), 3);
  write(path("out/table1.json"), R"({"rows": [{"patch": "1"}]})");
  EXPECT_REFUSED(run({"gate", "out", "--gates", "gates.yaml"}),
                 AllOf(HasSubstr("table1.json"), HasSubstr("is no Table 1")));
}

TEST_F(RunPatch, WithoutAReportThatOfAnEarlierRunIsGone) {
  ASSERT_EQ(run_patch("out").exit_code, 0);
  ASSERT_TRUE(fs::exists(path("out/report.html")));
  ASSERT_EQ(run_patch("out", {"--no-report"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("out/report.html")));
}

TEST_F(RunPatch, DamagedRecordOfStagesMeansDoneAnew) {
  ASSERT_EQ(run_patch("out", {"--no-report"}).exit_code, 0);
  const auto stages = read_json(path("out/1/stages.json"));
  for (const char* key : {"key", "files"}) {
    auto damaged = stages;
    for (auto& stage : damaged) stage[key] = nullptr;
    write(path("out/1/stages.json"), damaged.dump());
    const ProgramResult again = run_patch("out", {"--no-report", "--resume"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_THAT(again.err, HasSubstr("0 finished stages skipped")) << key;
  }
}

TEST_F(RunPatch, PatchOfAnotherCrsThanTheCloudIsRefusedByEvaluateToo) {
  const std::vector<std::string> arguments{"evaluate", "--lines",          "patch/truth.geojson",
                                           "--patch",  "patch/patch.yaml", "--out",
                                           "out",      "--no-report"};
  ASSERT_EQ(run(arguments).exit_code, 0);
  edit_patch("25832", "25833");
  EXPECT_REFUSED(run(arguments),
                 AllOf(HasSubstr("patch.yaml"), HasSubstr("patch and cloud do not match"),
                       HasSubstr("--assume-crs")));
}

TEST_F(RunPatch, WrongInputsAreFoundBeforeTheWorkBegins) {
  EXPECT_REFUSED(run_patch("out", {"--gross-m", "nan"}), HasSubstr("--gross-m = nan"));
  edit_patch("lidar.las", "none.las");
  EXPECT_REFUSED(run_patch("out"), HasSubstr("none.las"));
  edit_patch("none.las", "lidar.las");
  edit_patch("25832", "2154");
  EXPECT_REFUSED(run_patch("out"),
                 AllOf(HasSubstr("patch and cloud do not match"), HasSubstr("--assume-crs")));
  EXPECT_FALSE(fs::exists(path("out/1/segments.left.csv")));
  EXPECT_EQ(run_patch("out", {"--assume-crs", "EPSG:25832", "--no-report"}).exit_code, 0);
}

TEST_F(RunPatch, TrueLinesOfAnotherCrsAreRefused) {
  std::string text = read(path("patch/truth.geojson"));
  write(path("patch/truth.geojson"), text.replace(text.find("25832"), 5, "25833"));
  EXPECT_REFUSED(run_patch("out"), AllOf(HasSubstr("truth.geojson"), HasSubstr("do not match")));
}

TEST_F(RunPatch, ATileNamedTwiceCountsOnce) {
  ASSERT_EQ(run_patch("once", {"--no-report"}).exit_code, 0);
  edit_patch("lidar.las", "\"*.las\"\n  - lidar.las");
  ASSERT_EQ(run_patch("twice", {"--no-report"}).exit_code, 0);
  EXPECT_EQ(read(path("once/table2.csv")), read(path("twice/table2.csv")));
}

TEST_F(RunPatch, OnePictureForBothCamerasIsWarnedOf) {
  fs::copy_file(path("patch/left.tif"), path("patch/right.tif"),
                fs::copy_options::overwrite_existing);
  EXPECT_THAT(run_patch("out", {"--no-report"}).err, HasSubstr("hold the same picture"));
}

TEST_F(RunPatch, GivesTheSameBytesForAnyNumberOfThreads) {
  ASSERT_EQ(run_patch("one", {"--jobs", "1"}).exit_code, 0);
  ASSERT_EQ(run_patch("four", {"--jobs", "4"}).exit_code, 0);
  EXPECT_EQ(results_in("one"), results_in("four"));
}

TEST_F(RunPatch, WithoutLidarWritesLinesAndSaysWhyNoneIsEvaluated) {
  remove_line("lidar");
  const ProgramResult result = run_patch("out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto evaluation = read_json(path("out/1/evaluation.joint.json"));
  ASSERT_GT(evaluation["lines"].size(), 20U);
  for (const auto& line : evaluation["lines"]) {
    EXPECT_THAT(line["status"], testing::AnyOf("no_lidar", "not_reconstructed", "too_short"));
  }
  EXPECT_EQ(read_json(path("out/1/lines.joint.geojson"))["features"].size(),
            evaluation["lines"].size());
}

TEST_F(RunPatch, ReconstructFromTheMatchesOfARunGivesItsLines) {
  ASSERT_EQ(run_patch("out").exit_code, 0);
  const ProgramResult result = run({"reconstruct", "patch/patch.yaml", "--matches",
                                    "out/1/matches.csv", "--out", "lines.geojson"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read(path("lines.geojson")), read(path("out/1/lines.joint.geojson")));

  write(path("out/1/matches.csv"), "left_id,right_id\n0,999999\n");
  EXPECT_REFUSED(run({"reconstruct", "patch/patch.yaml", "--matches", "out/1/matches.csv", "--out",
                      "lines.geojson"}),
                 AllOf(HasSubstr("matches.csv"), HasSubstr("right_id = 999999, must be in 0..")));
}

TEST_F(RunPatch, MissingImageIsNamed) {
  fs::remove(path("patch/right.tif"));
  EXPECT_REFUSED(run_patch("out"), HasSubstr("right.tif"));
  EXPECT_FALSE(fs::exists(path("out/1/segments.left.csv")));
}

TEST_F(RunPatch, InvertedHeightRangeIsRefused) {
  remove_line("height_range");
  write(path("patch/patch.yaml"), read(path("patch/patch.yaml")) + "height_range: [300, 200]\n");
  EXPECT_REFUSED(run_patch("out"), HasSubstr("height_range"));
}

TEST_F(RunPatch, TwoPatchesOfOneIdAreRefused) {
  EXPECT_REFUSED(run({"run", "patch/patch.yaml", "patch/patch.yaml", "--out", "out"}),
                 HasSubstr("id 1"));
}

}  // namespace
}  // namespace ridgeline::cli
