// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/matches_file.h"
#include "io/project/segments_file.h"
#include "tests/cli/cli_fixture.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class Match : public SmallPair {};

TEST_F(Match, WritesMatchesAndAnOverlay) {
  const ProgramResult result =
      run({"match", "pair/patch.yaml", "--out", "m.csv", "--overlay", "m.png"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("matched"));
  EXPECT_GT(io::read_matches(path("m.csv").string()).size(), 20U);
  // the overlay shows both images side by side, enlarged twice
  const cv::Mat overlay = cv::imread(path("m.png").string());
  const cv::Mat left = cv::imread(path("pair/left.tif").string());
  const cv::Mat right = cv::imread(path("pair/right.tif").string());
  EXPECT_EQ(overlay.cols, 2 * (left.cols + right.cols));
  EXPECT_EQ(overlay.rows, 2 * std::max(left.rows, right.rows));
}

TEST_F(Match, GivesTheSameBytesForAnyNumberOfThreads) {
  ASSERT_EQ(run({"match", "pair/patch.yaml", "--out", "1/m.csv", "--jobs", "1"}).exit_code, 0);
  ASSERT_EQ(run({"match", "pair/patch.yaml", "--out", "2/m.csv", "--jobs", "2"}).exit_code, 0);
  EXPECT_EQ(read(path("1/m.csv")), read(path("2/m.csv")));
}

TEST_F(Match, WithSegmentsIsWhatReconstructMakesOfThePatch) {
  ASSERT_EQ(
      run({"match", "pair/patch.yaml", "--out", "seen/m.csv", "--segments", "seen"}).exit_code, 0);
  const auto rows = io::read_matches(path("seen/m.csv").string());
  EXPECT_GT(std::ranges::count(rows, "guided", &Correspondence::matcher), 0);
  for (const char* image : {"left", "right"}) {
    const std::string file = std::string("seen/segments.") + image + ".csv";
    const auto segments = io::read_segments(path(file).string());
    EXPECT_GT(segments.size(), 20U);
    EXPECT_TRUE(std::ranges::is_sorted(segments, {}, &EdgeSegment::guided));
  }
  ASSERT_EQ(run({"reconstruct", "pair/patch.yaml", "--matches", "seen/m.csv", "--out",
                 "of_files.geojson"})
                .exit_code,
            0);
  ASSERT_EQ(run({"reconstruct", "pair/patch.yaml", "--out", "at_once.geojson"}).exit_code, 0);
  EXPECT_EQ(read(path("of_files.geojson")), read(path("at_once.geojson")));
}

TEST_F(Match, ThatIsGuidedNeedsItsSegments) {
  ASSERT_EQ(run({"match", "pair/patch.yaml", "--out", "m.csv", "--segments", "seen"}).exit_code, 0);
  EXPECT_REFUSED(
      run({"reconstruct", "pair/patch.yaml", "--matches", "m.csv", "--out", "lines.geojson"}),
      AllOf(HasSubstr("m.csv"), HasSubstr("Guided matches need the segments.IMAGE.csv")));
}

TEST_F(Match, HasItsSegmentsBesideIt) {
  ASSERT_EQ(run({"match", "pair/patch.yaml", "--out", "of_match/m.csv"}).exit_code, 0);
  ASSERT_EQ(run({"run", "pair/patch.yaml", "--out", "of_run", "--no-report"}).exit_code, 0);
  EXPECT_EQ(read(path("of_match/m.csv")), read(path("of_run/pair/matches.csv")));
  for (const char* const file : {"segments.left.csv", "segments.right.csv"})
    EXPECT_EQ(read(path("of_match") / file), read(path("of_run/pair") / file)) << file;
}

TEST_F(Match, ByChioTellsHowEachLineCameAbout) {
  const ProgramResult result = run({"match", "pair/patch.yaml", "--matcher", "chio", "--out",
                                    "m.csv", "--provenance", "chio.csv"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("1 and 2"), HasSubstr("then 3 and 4"), HasSubstr("relaxed to")));
  const auto rows = io::read_matches(path("m.csv").string());
  ASSERT_GT(rows.size(), 20U);
  EXPECT_EQ(rows.front().matcher, "chio");
  const std::string provenance = read(path("chio.csv"));
  EXPECT_EQ(std::count(provenance.begin(), provenance.end(), '\n') - 1,
            std::ranges::count(rows, "chio", &Correspondence::matcher));
  EXPECT_REFUSED(run({"match", "pair/patch.yaml", "--out", "m.csv", "--provenance", "chio.csv"}),
                 HasSubstr("requires --matcher chio"));
}

TEST_F(Match, SaysWhatIsWrongWithItsInput) {
  EXPECT_REFUSED(run({"match", "none.yaml", "--out", "m.csv"}), HasSubstr("none.yaml"));
  write(path("p.yaml"), "match:\n  max_turn_deg: 91\n");
  EXPECT_REFUSED(run({"match", "pair/patch.yaml", "--out", "m.csv", "--config", "p.yaml"}),
                 HasSubstr("p.yaml: line 2: max_turn_deg = 91, must be in [0, 90]"));
  for (const char* input : {"pair/patch.yaml", "pair/left.tif", "pair/matches.csv"}) {
    EXPECT_REFUSED(run({"match", "pair/patch.yaml", "--out", input}),
                   AllOf(HasSubstr(input), HasSubstr("would be overwritten")));
  }
  EXPECT_REFUSED(run({"match", "pair/patch.yaml", "--out", "m.csv", "--overlay", "m.csv"}),
                 HasSubstr("would be overwritten"));
  EXPECT_REFUSED(run({"match", "pair/patch.yaml", "--out", "m.csv", "--overlay", "m.jpg"}),
                 HasSubstr("--overlay = m.jpg, must end in .png"));
  std::filesystem::remove(path("pair/right.tif"));
  EXPECT_REFUSED(run({"match", "pair/patch.yaml", "--out", "m.csv"}), HasSubstr("right.tif"));
  EXPECT_FALSE(std::filesystem::exists(path("m.csv")));
}

}  // namespace
}  // namespace ridgeline::cli
