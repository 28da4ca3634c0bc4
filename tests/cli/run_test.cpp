// SPDX-License-Identifier: BSD-3-Clause
#include "io/files/sha256.h"
#include "tests/cli/run_fixture.h"

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

TEST_F(RunSample, WritesTheFilesOfTheContractAndPrintsBothTables) {
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

TEST_F(RunPatch, ResumeSkipsWhatIsFinishedAndGivesTheSameBytes) {
  ASSERT_EQ(run_patch("out").exit_code, 0);
  const auto first = results_in("out");
  const ProgramResult again = run_patch("out", {"--resume"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.err, HasSubstr("7 finished stages skipped"));
  EXPECT_EQ(results_in("out"), first);

  // a lost file is made again, with the same content, so that what depends on it stays
  fs::remove(path("out/1/lines.joint.geojson"));
  const ProgramResult repaired = run_patch("out", {"--resume"});
  EXPECT_THAT(repaired.err, HasSubstr("6 finished stages skipped"));
  EXPECT_EQ(results_in("out"), first);

  for (const char* name : {"evaluation.joint.csv", "accuracy.joint.md"}) {
    fs::remove(path("out/1") / name);
    EXPECT_THAT(run_patch("out", {"--resume"}).err, HasSubstr("6 finished stages skipped")) << name;
    EXPECT_EQ(results_in("out"), first);
  }

  // another option of the matching leaves the extraction alone
  write(path("p.yaml"), "match: {min_probability: 0.9}\n");
  const ProgramResult other = run_patch("out", {"--resume", "--config", "p.yaml"});
  EXPECT_THAT(other.err, HasSubstr("2 finished stages skipped"));
}

TEST_F(RunPatch, ResumeRepeatsOnlyWhatDependsOnAChange) {
  const std::vector<std::string> options{"--resume", "--no-report", "--max-y-parallax-px", "0"};
  const auto skipped = [&] { return run_patch("out", options).err; };
  ASSERT_EQ(run_patch("out", options).exit_code, 0);
  // the heights: not the segments of the images
  edit_patch("height_range: [228,", "height_range: [227,");
  EXPECT_THAT(skipped(), HasSubstr("1 finished stages skipped"));
  // a camera: the same
  edit_patch("- [6997.1768634974951,", "- [6997.1768634974963,");
  EXPECT_THAT(skipped(), HasSubstr("1 finished stages skipped"));
  // one image: everything, as all images are searched at a common size
  fs::copy_file(path("patch/left.tif"), path("patch/right.tif"),
                fs::copy_options::overwrite_existing);
  EXPECT_THAT(skipped(), HasSubstr("0 finished stages skipped"));
  // a comment: nothing
  edit_patch("id: \"1\"\n", "id: \"1\"  # the same\n");
  EXPECT_THAT(skipped(), HasSubstr("7 finished stages skipped"));
}

TEST_F(RunPatch, InputsAreNeverWrittenOver) {
  const auto before = results_in("patch");
  fs::create_directory(path("in"));
  fs::rename(path("patch"), path("in/1"));
  EXPECT_REFUSED(run({"run", "in/1/patch.yaml", "--out", "in"}),
                 AllOf(HasSubstr("in/1/matches.csv"), HasSubstr("would be overwritten")));
  EXPECT_REFUSED(run({"reconstruct", "in/1/patch.yaml", "--out", "in/1/truth.geojson"}),
                 HasSubstr("would be overwritten"));
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
    EXPECT_REFUSED(run({command, "out"}), HasSubstr("lists method joint of patch 1"));
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
                 AllOf(HasSubstr("table1.json"), HasSubstr("is not a Table 1")));
}

TEST_F(RunPatch, WithoutAReportThatOfAnEarlierRunIsGone) {
  ASSERT_EQ(run_patch("out").exit_code, 0);
  ASSERT_TRUE(fs::exists(path("out/report.html")));
  ASSERT_EQ(run_patch("out", {"--no-report"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("out/report.html")));
}

TEST_F(RunPatch, StagesThatTheUserChangedAreNotReplaced) {
  ASSERT_EQ(run_patch("out", {"--no-report"}).exit_code, 0);
  write(path("out/1/matches.csv"), "mine");
  EXPECT_REFUSED(run_patch("out", {"--no-report", "--resume"}), HasSubstr("out/1/matches.csv"));
  EXPECT_EQ(read(path("out/1/matches.csv")), "mine");
}

TEST_F(RunPatch, DamagedRecordOfStagesMeansDoneAnew) {
  ASSERT_EQ(run_patch("out", {"--no-report"}).exit_code, 0);
  const auto stages = read_json(path("out/1/stages.json"));
  for (const char* key : {"key", "files"}) {
    auto damaged = stages;
    for (auto& stage : damaged) stage[key] = nullptr;
    write(path("out/1/stages.json"), damaged.dump());
    nlohmann::json run = read_json(path("out/run.json"));
    for (auto& file : run["files"]) {
      if (file["path"] == "1/stages.json")
        file["sha256"] = io::sha256_of_file(path("out/1/stages.json").string());
    }
    write(path("out/run.json"), run.dump());
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
                 HasSubstr("outside the area of use of RGF93 v1 / Lambert-93; give the system of"));
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
  EXPECT_THAT(run_patch("out", {"--no-report"}).err, HasSubstr("have the same pixels"));
}

TEST_F(RunPatch, EndsWithTheStageThatUntilNames) {
  const ProgramResult matched = run_patch("out", {"--until", "match"});
  ASSERT_EQ(matched.exit_code, 0) << matched.err;
  EXPECT_THAT(matched.out, HasSubstr("pairwise"));
  EXPECT_TRUE(fs::exists(path("out/1/matches.csv")));
  for (const char* later : {"1/surface.las", "1/lines.direct.geojson", "table2.md", "report.html"})
    EXPECT_FALSE(fs::exists(path("out") / later)) << later;
  EXPECT_THAT(run_patch("out", {"--resume"}).err, HasSubstr("3 finished stages skipped"));
  const std::string lines = read(path("out/1/lines.direct.geojson"));

  // What still follows from the inputs is kept by --resume, and removed without it.
  ASSERT_EQ(run_patch("out", {"--until", "extract", "--resume"}).exit_code, 0);
  EXPECT_EQ(read(path("out/1/lines.direct.geojson")), lines);
  ASSERT_EQ(run_patch("out", {"--until", "extract"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(path("out/1/edges.left.csv")));
  for (const char* later : {"matches.csv", "verdicts.csv", "lines.direct.geojson"})
    EXPECT_FALSE(fs::exists(path("out/1") / later)) << later;
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
  ASSERT_EQ(run_patch("out", {"--methods", "lines"}).exit_code, 0);
  const ProgramResult result = run({"reconstruct", "patch/patch.yaml", "--matches",
                                    "out/1/matches.csv", "--out", "lines.geojson"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(read(path("lines.geojson")), read(path("out/1/lines.lines.geojson")));

  write(path("out/1/matches.csv"), "left_id,right_id\n0,999999\n");
  EXPECT_REFUSED(run({"reconstruct", "patch/patch.yaml", "--matches", "out/1/matches.csv", "--out",
                      "others.geojson"}),
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
