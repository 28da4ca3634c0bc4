// SPDX-License-Identifier: BSD-3-Clause
// Patches of three images and more.
#include "tests/cli/cli_fixture.h"

#include <algorithm>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// A small village in three images of a strip.
class ThreeImages : public Cli {
 protected:
  void SetUp() override {
    const ProgramResult made =
        run({"simulate", "--out", "patch", "--seed", "3", "--extent-m", "40,40",
             "--samples-per-side", "1", "--focal-length-px", "7000", "--views", "strip:3"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  [[nodiscard]] ProgramResult run_patch(const std::string& out,
                                        const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"run",       "patch/patch.yaml", "--out",      out,
                                   "--methods", "direct,joint",     "--no-report"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  [[nodiscard]] std::size_t n_lines_with(const std::string& file, const std::string& text) const {
    const std::string lines = read(path(file));
    std::size_t n = 0;
    for (std::size_t at = lines.find(text); at != std::string::npos; at = lines.find(text, at + 1))
      ++n;
    return n;
  }
};

TEST_F(ThreeImages, AreAllUsed) {
  const ProgramResult result = run_patch("out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("the papers use two")));
  EXPECT_THAT(names_in(path("out/patch")),
              IsSupersetOf({"tracks.csv", "matches.csv", "pairs", "segments.strip1.csv",
                            "segments.strip2.csv", "segments.strip3.csv"}));
  EXPECT_THAT(read(path("out/patch/tracks.csv")),
              AllOf(HasSubstr(",strip1,"), HasSubstr(",strip2,"), HasSubstr(",strip3,")));
  const std::string file = "out/patch/lines.direct.geojson";
  EXPECT_GT(n_lines_with(file, "\"n_images\":3"), 2 * n_lines_with(file, "\"n_images\":2"));
  EXPECT_THAT(read(path(file)), HasSubstr("\"sightings\":[[\"strip2\","));
  EXPECT_THAT(read(path("out/patch/accuracy.direct.md")), HasSubstr("| n_images"));
  EXPECT_THAT(read(path("out/patch/evaluation.direct.json")), HasSubstr("\"n_images\": 3"));
  write(path("gates.yaml"), "gates: [{n_images: 3, method: direct, max: 5, n_min: 20}]\n");
  const ProgramResult gated = run({"gate", "out", "--gates", "gates.yaml"});
  EXPECT_EQ(gated.exit_code, 0) << gated.err;
  EXPECT_THAT(gated.out, HasSubstr("of 3 images"));
}

TEST_F(ThreeImages, HaveTracksThatTheTrueOnesJudge) {
  const ProgramResult result = run_patch("out");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("Tracks, by true edges"));
  EXPECT_THAT(read(path("out/table1.md")), HasSubstr("sighting precision %"));
  EXPECT_THAT(read(path("out/table1.tracks.csv")), HasSubstr("\npatch,total,3,"));
  const auto tracks = read_json(path("out/table1.json"))["tracks"][0];
  EXPECT_GT(tracks["cells"].size(), 5U);
  write(path("gates.yaml"),
        "gates:\n  - {metric: sighting_precision, min: 0.9, n_min: 50}\n"
        "  - {metric: edge_recall, n_images: 3, class: not_aligned, min: 0.4}\n");
  const ProgramResult gated = run({"gate", "out", "--gates", "gates.yaml"});
  EXPECT_EQ(gated.exit_code, 0) << gated.out << gated.err;
  const ProgramResult info = run({"info", "patch/tracks.csv"});
  EXPECT_THAT(info.out,
              AllOf(HasSubstr("table of reference tracks"), HasSubstr("reference_tracks")));
  EXPECT_THAT(run({"info", "out/patch/tracks.csv"}).out, HasSubstr(": table of tracks"));
}

TEST_F(ThreeImages, AreComparedWithTwoInSpace) {
  ASSERT_EQ(run_patch("three").exit_code, 0);
  write(path("two.yaml"), "tracks: {all_views: false}\n");
  ASSERT_EQ(run_patch("two", {"--config", "two.yaml"}).exit_code, 0);
  EXPECT_GT(n_lines_with("three/patch/lines.joint.geojson", "\"class_base\":\"not_aligned\""), 20U);
  EXPECT_EQ(read_json(path("two/run.json"))["n_views"]["patch"], 2);
  const ProgramResult result = run({"compare", "two", "three", "--out", "compared"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("A used 2 images, B 3"), Not(HasSubstr("Warning"))));
  const auto compared = read_json(path("compared/compare.json"))["comparisons"][0];
  EXPECT_GT(compared["n_common"], 3 * compared["n_only_a"].get<int>());
  // Lines of one place are of one edge: their distances from the planes differ by less than the limit of pairing.
  EXPECT_LT(compared["common"].back()["rms_ratio"], 1.5);
}

TEST_F(ThreeImages, GiveTheSameForOneThreadAndWhenResumed) {
  ASSERT_EQ(run_patch("out", {"--jobs", "1"}).exit_code, 0);
  const std::string first = read(path("out/patch/lines.joint.geojson"));
  ASSERT_EQ(run_patch("again", {"--jobs", "2"}).exit_code, 0);
  EXPECT_EQ(read(path("again/patch/lines.joint.geojson")), first);
  std::filesystem::remove(path("out/patch/lines.joint.geojson"));
  ASSERT_EQ(run_patch("out", {"--resume"}).exit_code, 0);
  EXPECT_EQ(read(path("out/patch/lines.joint.geojson")), first);
}

TEST_F(ThreeImages, AreMatchedByChioOverAllPairs) {
  const ProgramResult result = run_patch("out", {"--matcher", "chio", "--methods", "direct"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(names_in(path("out/patch")), IsSupersetOf({"chio.csv", "tracks.csv", "pairs"}));
  std::size_t n_pairs = 0;
  for (const auto& pair : std::filesystem::directory_iterator(path("out/patch/pairs"))) {
    EXPECT_THAT(read((pair.path() / "matches.csv").string()), HasSubstr(",chio\n")) << pair.path();
    ++n_pairs;
  }
  EXPECT_GE(n_pairs, 1U);
  EXPECT_GT(n_lines_with("out/patch/lines.direct.geojson", "\"n_images\":3"), 10U);
}

TEST_F(ThreeImages, AreTwoForThePapers) {
  const ProgramResult result = run_patch("out", {"--preset", "published"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("the papers use two"));
  EXPECT_EQ(n_lines_with("out/patch/lines.direct.geojson", "\"n_images\":3"), 0U);
}

}  // namespace
}  // namespace ridgeline::cli
