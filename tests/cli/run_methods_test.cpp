// SPDX-License-Identifier: BSD-3-Clause
// What matchers, methods and their switches give in a run.
#include "tests/cli/run_fixture.h"

#include <algorithm>
#include <map>
#include <set>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

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

TEST_F(RunPatch, LinesOfChioTellHowTheyWereAcquired) {
  const ProgramResult result = run_patch("out", {"--matcher", "chio"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(read(path("out/table1.csv")), HasSubstr("\n1,chio,"));
  EXPECT_THAT(read(path("out/1/matches.csv")), HasSubstr(",chio\n"));
  EXPECT_THAT(read(path("out/1/unmatched.csv")), HasSubstr("epipolar_degenerate"));
  EXPECT_THAT(read(path("out/1/chio.csv")),
              testing::StartsWith("left_id,right_id,linked_right_ids,process,neighbour_left_id,"
                                  "neighbour_height_m,height_limit_m,n_pieces,"));
  const ProgramResult again = run_patch("out", {"--matcher", "chio", "--resume"});
  EXPECT_THAT(again.err, HasSubstr("7 finished stages skipped"));

  // the file does not stay beside those of the next run
  ASSERT_EQ(run_patch("out", {"--no-report"}).exit_code, 0);
  EXPECT_THAT(names_in(path("out/1")), Not(Contains(HasSubstr("chio"))));
}

TEST_F(RunSample, RunsWithDifferentMatchersAreComparedByWhatTheyFind) {
  write(path("same.yaml"), "match: {guided: false}\n");  // guided matching adds segments
  for (const std::string matcher : {"pairwise", "chio"}) {
    ASSERT_EQ(run_patch("m/" + matcher, {"--matcher", matcher, "--no-report", "--methods", "direct",
                                         "--config", "same.yaml"})
                  .exit_code,
              0);
  }
  const ProgramResult result = run({"compare", "m/pairwise", "m/chio", "--out", "cmp"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("\n1      pairwise  pairwise  "),
                                HasSubstr("\n1      chio      chio  ")));
  EXPECT_THAT(read(path("cmp/compare.md")),
              AllOf(HasSubstr("| 1 | pairwise | pairwise |"), HasSubstr("| 1 | chio | chio |")));
  const auto rows = read_json(path("cmp/compare.json"))["rows"];
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_GT(rows[0]["correct"], rows[1]["correct"]);

  // other segments have other ids, so that the lines are compared
  write(path("p.yaml"), "extract: {min_length_px: 20}\n");
  ASSERT_EQ(run_patch("m/chio", {"--matcher", "chio", "--no-report", "--methods", "direct",
                                 "--config", "p.yaml"})
                .exit_code,
            0);
  const ProgramResult lines = run({"compare", "m/pairwise", "m/chio"});
  EXPECT_EQ(lines.exit_code, 0) << lines.err;
  EXPECT_THAT(lines.out, HasSubstr("Lines are paired one to one"));
}

TEST_F(RunPatch, RefusesAnUnknownMatcher) {
  for (const char* matcher : {"other", "pairwise,chio"}) {
    EXPECT_REFUSED(run_patch("out", {"--matcher", matcher}),
                   HasSubstr(std::string(matcher) + ", must be pairwise or chio"));
  }
}

TEST_F(RunSample, MethodsDifferOnAlignedLinesOnlyUnlessFacesAdjustThem) {
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

TEST_F(RunPatch, DirectAndJointAreHeldToBeEqualOnlyWithoutFacesBeside) {
  const auto report_of = [&](const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"--no-report"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run_patch(out, arguments).exit_code, 0);
    EXPECT_EQ(run({"compare", out, "--out", out + "/compared"}).exit_code, 0);
    return read(path(out + "/compared/compare.md"));
  };
  const auto n_differing = [&](const std::string& out) {
    return read_json(
        path(out + "/compared/compare.json"))["comparisons"][0]["n_not_aligned_differing"];
  };
  EXPECT_THAT(report_of("default", {}), Not(HasSubstr("Warning")));
  EXPECT_TRUE(n_differing("default").is_null());
  EXPECT_THAT(read(path("default/table2.md")), HasSubstr("faces_beside"));
  EXPECT_THAT(read(path("default/table2.common.md")), HasSubstr("faces_beside"));

  EXPECT_THAT(report_of("published", {"--preset", "published"}), Not(HasSubstr("Warning")));
  EXPECT_EQ(n_differing("published"), 0);
  EXPECT_THAT(read(path("published/table2.md")), Not(HasSubstr("faces_beside")));
}

TEST_F(RunSample, LinesOfPlanesAreCountedByThemselves) {
  // few edges are left, so that planes give lines where no edge does
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
  EXPECT_THAT(published.err, HasSubstr("planes is not a method of the papers"));
}

TEST_F(RunSample, LinesAreThoseOfTheNetworkAndOfPlanesWhereItHasNone) {
  write(path("few.yaml"),
        "extract: {min_length_px: 60, faint_edges: false}\nmatch: {guided: false}\n");
  ASSERT_EQ(run_patch("out", {"--config", "few.yaml", "--methods", "lines,network", "--no-report"})
                .exit_code,
            0);
  const nlohmann::json network = read_json(path("out/1/lines.network.geojson"))["features"];
  const nlohmann::json lines = read_json(path("out/1/lines.lines.geojson"))["features"];
  ASSERT_GT(lines.size(), network.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const nlohmann::json& properties = lines[i]["properties"];
    EXPECT_EQ(properties["method"], "lines");
    if (i < network.size()) {
      EXPECT_EQ(properties["id"], network[i]["properties"]["id"]);
      EXPECT_EQ(lines[i]["geometry"], network[i]["geometry"]);
    } else {
      EXPECT_EQ(properties["id"], "p" + std::to_string(i - network.size()));
      EXPECT_EQ(properties["status"], "planes");
    }
  }
}

TEST_F(RunPatch, LinesAreTheDefaultAndTheProduct) {
  const auto run_default = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"run", "patch/patch.yaml", "--out", "out", "--no-report"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  };
  const auto methods = [&] { return read_json(path("out/run.json"))["options"]["methods"]; };
  ASSERT_EQ(run_default({"--preset", "published"}).exit_code, 0);
  EXPECT_EQ(methods(), (nlohmann::json{"direct", "joint"}));
  const ProgramResult result = run_default({});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(methods(), nlohmann::json{"lines"});
  const ProgramResult several = run_default({"--methods", "direct,lines"});
  EXPECT_THAT(several.out, HasSubstr("out/1/judged.lines.gpkg"));
  write(path("gates.yaml"), "gates: [{metric: rms_m, max: 10}]\n");
  ASSERT_EQ(run({"gate", "out", "--gates", "gates.yaml", "--json", "gate.json"}).exit_code, 0);
  EXPECT_EQ(read_json(path("gate.json"))["gates"][0]["method"], "lines");
  EXPECT_REFUSED(run_default({"--preset", "published", "--methods", "lines"}),
                 HasSubstr("lines is not a method of the papers"));
}

TEST_F(RunPatch, KeepsAnInputAmongTheFilesOfAnotherMethod) {
  ASSERT_EQ(run_patch("out", {"--methods", "joint", "--no-report"}).exit_code, 0);
  remove_line("reference_lines");
  write(path("patch/patch.yaml"),
        read(path("patch/patch.yaml")) + "reference_lines: ../out/1/lines.joint.geojson\n");
  ASSERT_EQ(run_patch("out", {"--methods", "direct", "--no-report"}).exit_code, 0);
  EXPECT_THAT(names_in(path("out/1")), IsSupersetOf({"lines.joint.geojson"}));
  EXPECT_THAT(names_in(path("out/1")), Not(testing::Contains("evaluation.joint.json")));
}

TEST_F(RunPatch, LeavesNothingOfMethodsThatItDoesNotRun) {
  ASSERT_EQ(run_patch("out", {"--methods", "lines,joint", "--lines-format", "csv"}).exit_code, 0);
  ASSERT_THAT(names_in(path("out/1")),
              IsSupersetOf({"lines.joint.geojson", "lines.joint.csv", "judged.lines.gpkg",
                            "evaluation.joint.csv", "accuracy.lines.md", "fig8.joint.png"}));
  write(path("out/1/lines.mine.joint.geojson"), "{}");
  ASSERT_EQ(run_patch("out", {"--methods", "direct"}).exit_code, 0);
  for (const std::string& file : names_in(path("out/1"))) {
    if (file == "lines.mine.joint.geojson") continue;
    EXPECT_THAT(file, Not(testing::AnyOf(HasSubstr(".joint."), HasSubstr(".lines."))));
  }
}

}  // namespace
}  // namespace ridgeline::cli
