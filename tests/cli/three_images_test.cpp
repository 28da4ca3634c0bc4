// SPDX-License-Identifier: BSD-3-Clause
// Patches of three images and more.
#include "tests/cli/cli_fixture.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <set>
#include <sstream>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::Each;
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
  EXPECT_THAT(result.err, Not(HasSubstr("the published methods use two")));
  EXPECT_THAT(names_in(path("out/patch")),
              IsSupersetOf({"tracks.csv", "matches.csv", "pairs", "segments.strip1.csv",
                            "segments.strip2.csv", "segments.strip3.csv"}));
  EXPECT_THAT(read(path("out/patch/tracks.csv")),
              AllOf(HasSubstr(",strip1,"), HasSubstr(",strip2,"), HasSubstr(",strip3,")));
  const std::string file = "out/patch/lines.direct.geojson";
  EXPECT_GT(n_lines_with(file, "\"n_images\":3"), 2 * n_lines_with(file, "\"n_images\":2"));
  EXPECT_THAT(read(path(file)), HasSubstr("\"observations\":[[\"strip2\","));
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
  EXPECT_THAT(read(path("out/table1.md")), HasSubstr("observation precision %"));
  EXPECT_THAT(read(path("out/table1.tracks.csv")), HasSubstr("\npatch,total,3,"));
  const auto tracks = read_json(path("out/table1.json"))["tracks"][0];
  EXPECT_GT(tracks["cells"].size(), 5U);
  write(path("gates.yaml"),
        "gates:\n  - {metric: observation_precision, min: 0.9, n_min: 50}\n"
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
  EXPECT_THAT(result.out, AllOf(HasSubstr("A used 2 images, B used 3"), Not(HasSubstr("Warning"))));
  // joint: the faces beside a short line keep its slope, which two images alone do not.
  const auto compared = read_json(path("compared/compare.json"))["comparisons"][1];
  EXPECT_GT(compared["n_common"], 3 * compared["n_only_a"].get<int>());
  // Lines of one place are of one edge: their distances from the planes differ by less than the
  // limit of pairing.
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
  EXPECT_THAT(result.err, HasSubstr("the published methods use two"));
  EXPECT_EQ(n_lines_with("out/patch/lines.direct.geojson", "\"n_images\":3"), 0U);
}

TEST_F(ThreeImages, OfWhichTheFirstTwoHaveNoMatchStillGiveLines) {
  const cv::Mat seen = cv::imread(path("patch/strip3.tif").string());
  ASSERT_TRUE(cv::imwrite(path("patch/strip3.tif").string(),
                          cv::Mat(seen.size(), CV_8UC3, cv::Scalar(90, 90, 90))));
  std::string text = read(path("patch/patch.yaml"));
  text.erase(text.find("lidar:"), text.find("reference_matches") - text.find("lidar:"));
  write(path("patch/patch.yaml"), text);
  const ProgramResult result = run_patch("out");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(n_lines_with("out/patch/matches.csv", "pairwise"), 0U);
  EXPECT_THAT(result.out,
              AllOf(HasSubstr("no LIDAR given"), Not(HasSubstr("no line was reconstructed"))));
}

/// Three images, of which the third one does not fit.
class WrongThirdImage : public ThreeImages {
 protected:
  static constexpr const char* kThird =
      "patch/strip1.tif";  // the patch begins with strip2 and strip3

  void SetUp() override {
    ThreeImages::SetUp();
    ASSERT_LT(read(path("patch/patch.yaml")).find("strip3.tif"),
              read(path("patch/patch.yaml")).find("strip1.tif"));
  }
  void change(const std::function<void(const cv::Mat&, cv::Mat&)>& how) const {
    cv::Mat changed;
    how(cv::imread(path(kThird).string(), cv::IMREAD_UNCHANGED), changed);
    ASSERT_TRUE(cv::imwrite(path(kThird).string(), changed));
  }
};

TEST_F(WrongThirdImage, IsRefusedIfItIsTurned) {
  change([](const cv::Mat& in, cv::Mat& out) { cv::rotate(in, out, cv::ROTATE_180); });
  const auto names_it = AllOf(HasSubstr("strip1.tif"), HasSubstr("do not fit their cameras"),
                              HasSubstr("rotated by 180 degrees"));
  EXPECT_REFUSED(run_patch("out"), names_it);
  EXPECT_REFUSED(run({"reconstruct", "patch/patch.yaml", "--out", "l.geojson"}), names_it);
  EXPECT_EQ(run({"match", "patch/patch.yaml", "--out", "m.csv"}).exit_code, 0);  // the base pair
  EXPECT_EQ(run_patch("papers", {"--preset", "published"}).exit_code, 0);
}

TEST_F(WrongThirdImage, IsRefusedForItsBandsBeforeAnyWork) {
  change([](const cv::Mat& in, cv::Mat& out) { cv::cvtColor(in, out, cv::COLOR_BGR2GRAY); });
  EXPECT_REFUSED(run_patch("out"), AllOf(HasSubstr("strip1.tif"), HasSubstr("1 bands")));
  EXPECT_FALSE(std::filesystem::exists(path("out/patch/edges.strip2.csv")));
}

TEST_F(WrongThirdImage, IsNamedIfItHoldsThePictureOfAnother) {
  std::filesystem::copy_file(path("patch/strip3.tif"), path(kThird),
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_THAT(run_patch("out", {"--max-y-parallax-px", "0"}).err,
              AllOf(HasSubstr("strip3.tif and"), HasSubstr("strip1.tif have the same pixels")));
}

TEST_F(WrongThirdImage, IsNamedIfItShowsAnotherPlace) {
  std::string text = read(path("patch/patch.yaml"));
  const std::size_t image = text.find("id: strip1");
  const std::size_t begin = text.find("projection_matrix:", image);
  std::size_t end = begin;
  for (int row = 0; row < 3; ++row) end = text.find("]", end + 1);
  text.replace(begin, end + 1 - begin,  // 500 m to the east
               "projection_matrix: [[7000, 0, -300, -3594200000], [0, -7000, -300, 37821300000], "
               "[0, 0, -1, 1000]]");
  write(path("patch/patch.yaml"), text);
  const ProgramResult result = run_patch("out");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err,
              AllOf(HasSubstr("strip1.tif overlaps every other image by less than a tenth"),
                    HasSubstr("is not matched")));
  EXPECT_THAT(read_json(path("out/run.json"))["warnings"].dump(), HasSubstr("less than a tenth"));
}

/// The report of three images; its page holds one patch with one method.
class ThreeImagesReport : public ThreeImages {
 protected:
  void SetUp() override {
    ThreeImages::SetUp();
    const ProgramResult made =
        run({"run", "patch/patch.yaml", "--out", "out", "--methods", "direct"});
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  [[nodiscard]] nlohmann::json patch_of_page() const {
    const std::string page = read(path("out/report.html"));
    const std::string open = "id=\"report-data\">";
    const std::size_t begin = page.find(open) + open.size();
    return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin))
        .at("patches")
        .at(0);
  }
  /// The states of a line's views; "outside" for one that it does not lie in.
  [[nodiscard]] static std::vector<std::string> states_of(const nlohmann::json& line) {
    std::vector<std::string> states;
    for (const auto& view : line.at("views"))
      states.push_back(view.is_null() ? "outside" : view.at(0).get<std::string>());
    return states;
  }
};

TEST_F(ThreeImagesReport, HoldsEachImageOnceWithItsTracksAndPairs) {
  const nlohmann::json images = patch_of_page().at("images");
  ASSERT_EQ(images["views"].size(), 3U);
  EXPECT_EQ(images["views"][2]["aligned"].size(), 3U);
  EXPECT_EQ(images["pairs"].size(), 2U);  // a tree of three images
  EXPECT_EQ(images["pairs"][0]["base"], 0);
  EXPECT_EQ(images["pairs"][0]["search"], 1);
  EXPECT_TRUE(images["pairs"][0]["matches"][0].contains("verdict"));
  EXPECT_FALSE(images["pairs"][1]["matches"][0].contains("verdict"));
  const std::string rows = read(path("out/patch/tracks.csv"));
  std::size_t n_observations = 0;
  for (const auto& track : images["tracks"]) n_observations += track.size() / 2;
  EXPECT_EQ(n_observations + 1, std::ranges::count(rows, '\n'));
}

TEST_F(ThreeImagesReport, SaysWhatEachImageShowsOfALine) {
  std::size_t n_confirmed = 0;
  std::size_t n_unconfirmed = 0;
  const nlohmann::json patch = patch_of_page();
  for (const auto& line : patch["methods"][0]["lines"]) {
    std::set<int> views;
    for (const auto& observation : line["observations"]) views.insert(observation[0].get<int>());
    EXPECT_EQ(views.size(), line["n_images"].get<std::size_t>());
    const std::vector<std::string> states = states_of(line);
    ASSERT_EQ(states.size(), 3U);
    const auto n = [&](const char* state) { return std::ranges::count(states, state); };
    EXPECT_EQ(n("agrees") + n("differs") + n("sighted"), static_cast<std::ptrdiff_t>(views.size()));
    if (line["construction"] == "unconfirmed") {
      ++n_unconfirmed;
      EXPECT_EQ(n("missing") + n("hidden"), 1) << line["id"];
    } else if (views.size() == 3) {
      ++n_confirmed;
    }
  }
  EXPECT_GT(n_confirmed, 20U);
  EXPECT_GT(n_unconfirmed, 0U);
}

TEST_F(ThreeImagesReport, NamesTheSegmentsOfTheTracks) {
  std::map<int, std::vector<std::vector<double>>> rows;
  const nlohmann::json patch = patch_of_page();
  for (int view = 0; view < 3; ++view) {
    const std::string id = patch["images"]["views"][view]["id"];
    std::istringstream file(read(path("out/patch/segments." + id + ".csv")));
    for (std::string row; std::getline(file, row);) {
      std::istringstream cells(row);
      std::vector<double>& values = rows[view].emplace_back();
      for (std::string cell; values.size() < 5 && std::getline(cells, cell, ',');)
        values.push_back(std::atof(cell.c_str()));
    }
    rows[view].erase(rows[view].begin());  // the header
  }
  std::size_t n_known = 0;
  for (const auto& line : patch["methods"][0]["lines"]) {
    for (const auto& observation : line["observations"]) {
      if (observation[1].is_null()) continue;
      ++n_known;
      const auto& row = rows[observation[0].get<int>()].at(observation[1].get<std::size_t>());
      // the middle of what the line was made from lies on the segment, but for the correction of
      // its place
      const double x = 0.5 * (observation[2][0].get<double>() + observation[2][2].get<double>());
      const double y = 0.5 * (observation[2][1].get<double>() + observation[2][3].get<double>());
      const double dx = row[3] - row[1];
      const double dy = row[4] - row[2];
      constexpr double kMaxOffset_px = 2.0;
      EXPECT_LT(std::abs(dx * (y - row[2]) - dy * (x - row[1])) / std::hypot(dx, dy),
                kMaxOffset_px);
    }
  }
  EXPECT_GT(n_known, 50U);
}

TEST_F(ThreeImagesReport, SaysThatAnImageDiffers) {
  const std::string file = "out/patch/lines.direct.geojson";
  nlohmann::json lines = read_json(path(file));
  std::size_t moved = 0;
  while (lines["features"][moved]["properties"]["n_images"] != 3) ++moved;
  nlohmann::json& observation = lines["features"][moved]["properties"]["observations"].back();
  const std::string image = observation[0];
  for (const int k : {1, 2, 3, 4}) observation[k] = observation[k].get<double>() + 15.0;
  write(path(file), lines.dump());
  ASSERT_EQ(run({"report", "out"}).exit_code, 0);
  const nlohmann::json patch = patch_of_page();
  for (std::size_t view = 0; view < 3; ++view) {
    const std::string state = states_of(patch["methods"][0]["lines"][moved])[view];
    EXPECT_EQ(state == "differs", patch["images"]["views"][view]["id"] == image) << state;
  }
}

TEST_F(ThreeImagesReport, OfThePapersSaysThatFurtherImagesAreNotUsed) {
  ASSERT_EQ(run({"run", "patch/patch.yaml", "--out", "out", "--methods", "direct", "--preset",
                 "published"})
                .exit_code,
            0);
  const nlohmann::json patch = patch_of_page();
  EXPECT_EQ(patch["images"]["pairs"].size(), 1U);
  std::set<std::string> third;
  for (const auto& line : patch["methods"][0]["lines"]) third.insert(states_of(line)[2]);
  EXPECT_THAT(third, Each(::testing::AnyOf("not_used", "outside")));
}

}  // namespace
}  // namespace ridgeline::cli
