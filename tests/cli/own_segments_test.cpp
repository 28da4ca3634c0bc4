// SPDX-License-Identifier: BSD-3-Clause
// Patches with segments of another detector.
#include "io/files/csv_table.h"
#include "io/project/segments_file.h"
#include "tests/cli/cli_fixture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A small village in three images. Their segments are those of `extract`, of which files have
/// nothing but ids and ends.
class OwnSegments : public Cli {
 protected:
  void SetUp() override {
    const ProgramResult made =
        run({"simulate", "--out", "patch", "--seed", "3", "--extent-m", "40,40",
             "--samples-per-side", "1", "--focal-length-px", "7000", "--views", "strip:3"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    for (const char* id : kImages) {
      const std::string edges = fmt::format("{}.csv", id);
      ASSERT_EQ(run({"extract", fmt::format("patch/{}.tif", id), "--out", edges}).exit_code, 0);
      write(path("patch") / edges, reduced(path(edges).string()));
    }
  }

  static constexpr std::array kImages{"strip1", "strip2", "strip3"};

  /// Ids and ends of a file of segments; each second segment runs the other way.
  static std::string reduced(const std::string& file) {
    std::string text = "id,x1_px,y1_px,x2_px,y2_px\n";
    const std::vector<EdgeSegment> segments = io::read_segments(file);
    for (std::size_t id = 0; id < segments.size(); ++id) {
      Segment2 s = segments[id].in_image;
      if (id % 2 == 1) std::swap(s.start, s.end);
      text += fmt::format("{},{:.3f},{:.3f},{:.3f},{:.3f}\n", id, s.start.x(), s.start.y(),
                          s.end.x(), s.end.y());
    }
    return text;
  }

  using Ends = std::array<Eigen::Vector3d, 2>;

  /// The lines of a run by the ids of their segments in the first two images.
  [[nodiscard]] std::map<std::string, Ends> lines_of(const std::string& out) const {
    const nlohmann::json file = read_json(path(out) / "patch/lines.joint.geojson");
    std::map<std::string, Ends> lines;
    for (const auto& line : file.at("features")) {
      const auto& of_line = line.at("properties");
      const bool is_of_both = of_line.contains("left_id") && of_line.contains("right_id");
      if (line.at("geometry").is_null() || !is_of_both) continue;
      const auto& x = line.at("geometry").at("coordinates");
      const auto end = [&](int i) { return Eigen::Vector3d(x[i][0], x[i][1], x[i][2]); };
      lines[of_line.at("left_id").dump() + of_line.at("right_id").dump()] = {end(0), end(1)};
    }
    return lines;
  }

  /// The distance of the middle of a line from another line.
  static double distance(const Ends& a, const Ends& b) {
    return ridgeline::distance(Segment3{b[0], b[1]}, Eigen::Vector3d(0.5 * (a[0] + a[1])));
  }

  /// Writes patch/own.yaml, the patch with further keys.
  void write_patch(const std::string& keys) const {
    write(path("patch/own.yaml"), read(path("patch/patch.yaml")) + keys);
  }

  [[nodiscard]] ProgramResult run_patch(const std::string& patch,
                                        const std::string& out,
                                        const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"run",       "patch/" + patch, "--out",      out,
                                   "--methods", "joint",          "--no-report"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }

  static constexpr const char* kAll =
      "segments: {strip1: strip1.csv, strip2: strip2.csv, strip3: strip3.csv}\n"
      "segment_sigma_px: 0.15\n";
};

TEST_F(OwnSegments, OfOurDetectorGiveTheLinesOfANormalRun) {
  write_patch(kAll);
  ASSERT_EQ(run_patch("patch.yaml", "normal").exit_code, 0);
  const ProgramResult own = run_patch("own.yaml", "own");
  ASSERT_EQ(own.exit_code, 0) << own.err;
  EXPECT_THAT(own.err, Not(HasSubstr("not used")));
  for (const char* id : kImages) {
    const std::string file = fmt::format("patch/edges.{}.csv", id);
    const auto extracted = io::read_segments(path("normal/" + file).string());
    const auto taken = io::read_segments(path("own/" + file).string());
    ASSERT_EQ(taken.size(), extracted.size());
    for (std::size_t i = 0; i < taken.size(); ++i) {
      constexpr double kDigits_px = 1e-3;
      EXPECT_LT((taken[i].in_image.start - extracted[i].in_image.start).norm(), kDigits_px) << i;
      EXPECT_LT((taken[i].line.segment.end - extracted[i].line.segment.end).norm(), kDigits_px);
    }
  }
  const auto normal = lines_of("normal");
  const auto found = lines_of("own");
  EXPECT_GT(normal.size(), 20U);
  std::vector<double> distances_m;
  for (const auto& [ids, line] : normal) {
    if (found.contains(ids)) distances_m.push_back(distance(line, found.at(ids)));
  }
  std::ranges::sort(distances_m);
  EXPECT_GE(10 * distances_m.size(), 9 * normal.size());
  EXPECT_LT(distances_m.at(distances_m.size() / 2), 0.01);
  EXPECT_LT(distances_m.at(distances_m.size() * 9 / 10), 0.05);
  EXPECT_THAT(read_json(path("own/run.json")).at("inputs").dump(), HasSubstr("patch/strip3.csv"));
}

TEST_F(OwnSegments, OfSomeImagesStandBesideExtractedOnesOfTheOthers) {
  write_patch("segments: {strip2: strip2.csv}\n");
  write(path("patch/strip2.csv"), "id,x1_px,y1_px,x2_px,y2_px\n0,100,50,160,50\n");
  const ProgramResult result = run_patch("own.yaml", "own");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(io::read_segments(path("own/patch/edges.strip2.csv").string()).size(), 1U);
  EXPECT_EQ(read(path("own/patch/edges.strip3.csv")), read(path("strip3.csv")));
}

TEST_F(OwnSegments, AreReadAgainWhenTheyOrTheirSigmaChange) {
  write_patch(kAll);
  ASSERT_EQ(run_patch("own.yaml", "own").exit_code, 0);
  const std::string skipped = "finished stages skipped";
  EXPECT_THAT(run_patch("own.yaml", "own", {"--resume"}).err, HasSubstr("6 " + skipped));
  const std::string edges = "own/patch/edges.strip1.csv";
  const std::size_t n = io::read_segments(path(edges).string()).size();
  std::string rows = read(path("patch/strip1.csv"));
  rows.erase(rows.rfind('\n', rows.size() - 2) + 1);
  write(path("patch/strip1.csv"), rows);
  const ProgramResult again = run_patch("own.yaml", "own", {"--resume"});
  EXPECT_THAT(again.err, HasSubstr("1 " + skipped));  // check pairs
  EXPECT_EQ(io::read_segments(path(edges).string()).size(), n - 1);
  write_patch("segments: {strip1: strip1.csv, strip2: strip2.csv, strip3: strip3.csv}\n");
  EXPECT_THAT(run_patch("own.yaml", "own", {"--resume"}).err, HasSubstr("1 " + skipped));
}

TEST_F(OwnSegments, AreUsedByMatchAndReconstructAsByRun) {
  write_patch(kAll);
  ASSERT_EQ(run_patch("own.yaml", "own").exit_code, 0);
  ASSERT_EQ(run({"match", "patch/own.yaml", "--out", "of_match/m.csv"}).exit_code, 0);
  EXPECT_EQ(read(path("of_match/m.csv")), read(path("own/patch/matches.csv")));
  ASSERT_EQ(run({"reconstruct", "patch/own.yaml", "--method", "joint", "--out", "lines.geojson"})
                .exit_code,
            0);
  EXPECT_EQ(read(path("lines.geojson")), read(path("own/patch/lines.joint.geojson")));
}

TEST_F(OwnSegments, OfAWindowAreInPixelsOfTheFile) {
  std::string text = read(path("patch/patch.yaml"));
  const std::string file = "path: strip2.tif";
  ASSERT_NE(text.find(file), std::string::npos);
  text.replace(text.find(file), file.size(), file + "\n    window_px: [60, 40, 200, 180]");
  write(path("patch/own.yaml"), text + "segments: {strip2: strip2.csv}\n");
  write(path("patch/strip2.csv"), "id,x1_px,y1_px,x2_px,y2_px\n0,10,50,40,50\n1,100,50,160,50\n");
  const ProgramResult result = run_patch("own.yaml", "own", {"--max-y-parallax-px", "0"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("strip2.csv: 1 of 2 segments are ignored"));
  const auto used = io::read_segments(path("own/patch/edges.strip2.csv").string());
  ASSERT_EQ(used.size(), 1U);
  EXPECT_EQ(midpoint(used[0].in_image), Eigen::Vector2d(70, 10));
}

TEST_F(OwnSegments, ThatCannotBeAreRefusedBeforeAnyWork) {
  write_patch("segments: {strip1: strip1.csv}\n");
  write(path("patch/strip1.csv"), "id,x1_px,y1_px,x2_px,y2_px\n0,1,2,3,4\n1,1,2,9000,4\n");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"run", "patch/own.yaml", "--out", "own"},
        {"match", "patch/own.yaml", "--out", "m.csv"},
        {"reconstruct", "patch/own.yaml", "--out", "l.geojson"}}) {
    EXPECT_REFUSED(run(command), HasSubstr("patch/strip1.csv:3: x2_px = 9000, must be in [-5, "));
  }
  EXPECT_FALSE(std::filesystem::exists(path("own/patch")));
  std::filesystem::remove(path("patch/strip1.csv"));
  EXPECT_REFUSED(run_patch("own.yaml", "own"), HasSubstr("strip1.csv"));
  EXPECT_THAT(run({"info", "patch/own.yaml"}).out, HasSubstr("strip1.csv does not exist"));
}

TEST_F(OwnSegments, AreNotOfABlock) {
  write(path("block.yaml"),
        "block: b\nheight_range: auto\nlidar: patch/lidar.las\ncolmap: none\nsegments: {}\n");
  EXPECT_REFUSED(run({"block", "block.yaml", "--out", "b"}),
                 AllOf(HasSubstr("block.yaml: line 5"), HasSubstr("a block extracts its own")));
}

}  // namespace
}  // namespace ridgeline::cli
