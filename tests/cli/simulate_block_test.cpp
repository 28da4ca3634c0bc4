// SPDX-License-Identifier: BSD-3-Clause
// Blocks: frames in strips over a village, with one orientation, LIDAR in tiles and one truth.
#include "io/cloud/read_cloud.h"
#include "io/images/image.h"
#include "io/lines/read_lines.h"
#include "io/orientation/read_orientation.h"
#include "tests/cli/cli_fixture.h"
#include "tests/support/temp_folder.h"

#include <opencv2/imgcodecs.hpp>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

namespace ridgeline::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

/// A frame as the orientation states it.
struct StatedFrame {
  std::string file;
  ProjectionMatrix image_from_world;
  Eigen::Vector2d last_px;

  [[nodiscard]] bool shows(const Eigen::Vector3d& x) const {
    const Eigen::Vector2d x_px = project(image_from_world, x);
    return (x_px.array() >= 0.0).all() && (x_px.array() <= last_px.array()).all();
  }
};

class SimulateBlock : public Cli {
 protected:
  /// Small frames, of 0.4 m a pixel unless they have more of them.
  [[nodiscard]] ProgramResult simulate(const std::string& out,
                                       const std::vector<std::string>& more = {},
                                       const std::string& frame_px = "400,340") const {
    std::vector<std::string> arguments{"simulate", "--out",
                                       out,        "--seed",
                                       "3",        "--block",
                                       "2,3",      "--frame-px",
                                       frame_px,   "--samples-per-side",
                                       "1",        "--density-per-m2",
                                       "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  /// A block for the tests that only read it, made by the first of them.
  [[nodiscard]] fs::path made_once() const {
    static const io::TempFolder folder;
    const fs::path block = folder.file("b");
    if (!fs::exists(block)) {
      EXPECT_EQ(simulate(block.string(), {}, "700,600").exit_code, 0);
    }
    return block;
  }

  [[nodiscard]] static std::vector<StatedFrame> frames_of(const fs::path& block) {
    const YAML::Node yaml = YAML::LoadFile((block / "block.yaml").string());
    io::OrientationOptions options;
    options.cameras = (block / yaml["cameras"].as<std::string>()).string();
    const io::Orientation orientation =
        io::read_orientation((block / yaml["orientation"].as<std::string>()).string(), options);
    std::vector<StatedFrame> frames;
    for (const io::OrientedImage& image : orientation.images) {
      const InteriorOrientation& interior = orientation.cameras[image.camera.value()].interior;
      frames.push_back({(block / "frames" / image.name).string(),
                        projection_matrix(interior, image.exterior),
                        interior.size_px->cast<double>() - Eigen::Vector2d::Ones()});
    }
    return frames;
  }
};

/// The points of clouds, on the map, to the millimetre of the files.
std::multiset<std::tuple<long, long, long>> points_mm(const std::string& pattern) {
  io::ReadOptions all_classes;
  all_classes.classes.emplace();
  for (int c = 0; c < 20; ++c) all_classes.classes->insert(static_cast<std::uint8_t>(c));
  const io::PointCloud cloud = io::read_cloud({pattern}, all_classes);
  std::multiset<std::tuple<long, long, long>> points;
  for (const io::CloudPoint& p : cloud.points) {
    const Eigen::Vector3d x_mm =
        1000.0 * cloud.frame.world_from_local(Eigen::Vector3d(p.x, p.y, p.z));
    points.emplace(std::lround(x_mm.x()), std::lround(x_mm.y()), std::lround(x_mm.z()));
  }
  return points;
}

/// How many pixels beside the image of a line a picture has its steepest change, of those up to
/// four; and that change.
struct SteepestPlace {
  int beside_px = 0;
  double change = 0.0;
};

SteepestPlace steepest_beside(const cv::Mat& grey, const Segment2& line_px) {
  constexpr int kReach_px = 4;
  const Eigen::Vector2d across = normal(line_px);
  const auto at = [&](const Eigen::Vector2d& x_px) {
    return static_cast<double>(grey.at<std::uint8_t>(static_cast<int>(std::lround(x_px.y())),
                                                     static_cast<int>(std::lround(x_px.x()))));
  };
  SteepestPlace steepest;
  for (int beside = -kReach_px; beside <= kReach_px; ++beside) {
    double sum = 0.0;
    constexpr int kSamples = 40;
    for (int i = 0; i < kSamples; ++i) {
      const Eigen::Vector2d x_px =
          point_at(line_px, (i + 0.5) / kSamples) + static_cast<double>(beside) * across;
      sum += at(x_px + across) - at(x_px - across);
    }
    const double change = std::abs(sum) / kSamples;
    if (change > steepest.change) steepest = {beside, change};
  }
  return steepest;
}

TEST_F(SimulateBlock, HasFramesTilesOneTruthAndAFileThatNamesThem) {
  const ProgramResult made = simulate("b");
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("b: 6 frames, a village of "));
  EXPECT_THAT(names_in(path("b")),
              ElementsAre("block.yaml", "cameras.yaml", "frames", "lines.fair.geojson",
                          "lines.good.geojson", "lines.poor.geojson", "opk.csv", "simulate.json",
                          "tiles", "truth.geojson"));
  EXPECT_THAT(names_in(path("b/frames")), ElementsAre("01_01.tif", "01_02.tif", "01_03.tif",
                                                      "02_01.tif", "02_02.tif", "02_03.tif"));
  EXPECT_THAT(names_in(path("b/tiles")), ElementsAre("513000_5403000.las", "513000_5403100.las",
                                                     "513100_5403000.las", "513100_5403100.las"));
  EXPECT_THAT(read(path("b/block.yaml")),
              AllOf(HasSubstr("block: \"b\"\ncrs: \"EPSG:25832\"\norientation: opk.csv\n"
                              "cameras: cameras.yaml\nimages: frames/*.tif\nlidar: [tiles/*.las]\n"
                              "height_range: auto\narea: [513002, 5403002, "),
                    HasSubstr("patch_size_m: 60\nreference_lines: truth.geojson\n")));
  const io::ImageFacts facts = io::image_facts(path("b/frames/02_03.tif").string());
  EXPECT_EQ(facts.width_px, 400);
  EXPECT_EQ(facts.height_px, 340);
  EXPECT_THAT(read_json(path("b/simulate.json"))["files"], SizeIs(6 + 4 + 7));
  const ProgramResult again = simulate("b", {"--trees-per-lot", "1"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

/// Of all classes but the outliers, which are birds and what lies below the ground.
TEST_F(SimulateBlock, ShowsEveryPointOfItsAreaInTwoFramesOrMore) {
  const fs::path block = made_once();
  const auto area_m =
      YAML::LoadFile((block / "block.yaml").string())["area"].as<std::array<double, 4>>();
  const std::vector<StatedFrame> frames = frames_of(block);
  ASSERT_EQ(frames.size(), 6U);
  const io::PointCloud cloud = io::read_cloud({(block / "tiles/*.las").string()});
  Eigen::AlignedBox2d shown_m;
  int n_shown_once = 0;
  for (const io::CloudPoint& p : cloud.points) {
    const Eigen::Vector3d x = cloud.frame.world_from_local(Eigen::Vector3d(p.x, p.y, p.z));
    shown_m.extend(x.head<2>());
    const auto n_frames =
        std::ranges::count_if(frames, [&](const StatedFrame& frame) { return frame.shows(x); });
    n_shown_once += n_frames < 2 ? 1 : 0;
  }
  EXPECT_EQ(n_shown_once, 0) << "of " << cloud.points.size();
  EXPECT_TRUE(shown_m.contains(Eigen::Vector2d(area_m[0], area_m[1])));
  EXPECT_TRUE(shown_m.contains(Eigen::Vector2d(area_m[2], area_m[3])));
}

/// True lines are where the frames have edges, by the cameras that a reader of the orientation
/// gets.
TEST_F(SimulateBlock, DrawsTheTrueLinesWhereItsOrientationSaysThatTheyAre) {
  constexpr double kMinChange = 15.0;  // grey values; a roof may look like its garden
  constexpr double kMinLength_px = 25.0;
  const fs::path block = made_once();
  const io::LineSet truth = io::read_lines((block / "truth.geojson").string());
  int n_drawn = 0;
  int n_in_place = 0;
  for (const StatedFrame& frame : frames_of(block)) {
    const cv::Mat grey = cv::imread(frame.file, cv::IMREAD_GRAYSCALE);
    ASSERT_EQ(grey.cols, 700) << frame.file;
    for (const io::Line& line : truth.lines) {
      if (line.kind != "eave" && line.kind != "verge") continue;
      const Segment2 line_px = project(frame.image_from_world, line.segment_in_world);
      const bool is_inside = std::ranges::all_of(
          std::array{line_px.start, line_px.end}, [](const Eigen::Vector2d& x_px) {
            return (x_px.array() > 8.0).all() && x_px.x() < 690.0 && x_px.y() < 590.0;
          });
      if (!is_inside || length(line_px) < kMinLength_px) continue;
      const SteepestPlace steepest = steepest_beside(grey, line_px);
      if (steepest.change < kMinChange) continue;
      ++n_drawn;
      n_in_place += std::abs(steepest.beside_px) <= 1 ? 1 : 0;
    }
  }
  EXPECT_GT(n_drawn, 100);
  EXPECT_GT(n_in_place, 0.75 * n_drawn) << "of " << n_drawn;
}

TEST_F(SimulateBlock, HasTilesThatTogetherAreOneScanWithoutADoubledPoint) {
  const fs::path block = made_once();
  ASSERT_EQ(simulate("one", {"--tile-m", "1000"}, "700,600").exit_code, 0);
  ASSERT_THAT(names_in(path("one/tiles")), SizeIs(1));
  const auto one = points_mm(path("one/tiles/*.las").string());
  EXPECT_GT(one.size(), 10000U);
  EXPECT_EQ(points_mm((block / "tiles/*.las").string()), one);
  for (const auto& [x_mm, y_mm, z_mm] : points_mm((block / "tiles/513100_5403000.las").string())) {
    ASSERT_GE(x_mm, 513100000);
    ASSERT_LE(y_mm, 5403100000);
  }
}

TEST_F(SimulateBlock, HasTheSameBytesForAnyNumberOfThreads) {
  ASSERT_EQ(simulate("b", {"--jobs", "1", "--cross-strips", "1"}).exit_code, 0);
  const auto first = results_in("b");
  const ProgramResult again = simulate("b", {"--jobs", "2", "--cross-strips", "1"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(results_in("b"), first);
  EXPECT_TRUE(fs::exists(path("b/frames/03_01.tif")));
}

TEST_F(SimulateBlock, HasATruthWithTheNumberOfFramesThatSeeALine) {
  const nlohmann::json truth = read_json(made_once() / "truth.geojson");
  int n_seen = 0;  // the others have less than ten pixels, or trees hide them
  int most_images = 0;
  for (const nlohmann::json& line : truth["features"]) {
    const int n_images = line["properties"]["n_images"].get<int>();
    n_seen += n_images >= 2 ? 1 : 0;
    most_images = std::max(most_images, n_images);
  }
  EXPECT_GT(n_seen, 0.4 * static_cast<double>(truth["features"].size()));
  EXPECT_EQ(most_images, 6);
}

TEST_F(SimulateBlock, HasAnyOrientationAndItsWords) {
  const ProgramResult made = simulate("b", {"--orientation", "pat_b"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(read(path("b/block.yaml")),
              HasSubstr("orientation: pat_b.ori\ncameras: cameras.yaml\n"
                        "matrix: world_from_camera\n"));
  ASSERT_EQ(simulate("c", {"--orientation", "inpho"}).exit_code, 0);
  EXPECT_THAT(read(path("c/block.yaml")),
              AllOf(HasSubstr("orientation: inpho.prj\n"), Not(HasSubstr("cameras"))));
}

TEST_F(SimulateBlock, HasDegradedFramesThatAloneChange) {
  ASSERT_EQ(simulate("b").exit_code, 0);
  ASSERT_EQ(simulate("c", {"--blur-px", "1.5", "--bayer", "--jpeg-quality", "80",
                           "--degraded-views", "01_02,02_03"})
                .exit_code,
            0);
  for (const std::string& name : names_in(path("b/frames"))) {
    const bool is_degraded = name == "01_02.tif" || name == "02_03.tif";
    EXPECT_EQ(read(path("b/frames") / name) == read(path("c/frames") / name), !is_degraded) << name;
  }
  EXPECT_REFUSED(simulate("s", {"--bayer", "--degraded-views", "left"}),
                 HasSubstr("--degraded-views = left, must be one of 01_01, 01_02, 01_03, 02_01"));
}

TEST_F(SimulateBlock, WrongOnesAreRefusedWithTheOptionTheValueAndTheRule) {
  for (const std::vector<std::string>& option :
       std::vector<std::vector<std::string>>{{"--extent-m", "100,100"},
                                             {"--geometry", "chio_wang_2000"},
                                             {"--views", "strip:3"},
                                             {"--base-to-height", "0.3"},
                                             {"--oblique-tilt-deg", "30"}}) {
    EXPECT_REFUSED(simulate("s", option),
                   HasSubstr("--block and " + option[0] + ", must not both be given: "));
  }
  EXPECT_REFUSED(run({"simulate", "--out", "s", "--block", "2,3", "--no-images"}),
                 HasSubstr("--block and --no-images, must not both be given: "));
  for (const char* option : {"--cross-strips", "--tile-m"}) {
    EXPECT_REFUSED(run({"simulate", "--out", "s", option, "50"}),
                   HasSubstr(std::string(option) + ", must be with --block"));
  }
  for (const char* option : {"--forward-overlap", "--side-overlap"}) {
    EXPECT_REFUSED(run({"simulate", "--out", "s", option, "0.7"}),
                   HasSubstr(std::string(option) + ", must be with --block"));
  }
  EXPECT_REFUSED(run({"simulate", "--out", "s", "--block", "2"}), HasSubstr("--block"));
  EXPECT_REFUSED(run({"simulate", "--out", "s", "--block", "0,3"}),
                 AllOf(HasSubstr("--block"), HasSubstr("must be in [1, 99]")));
  EXPECT_REFUSED(run({"simulate", "--out", "s", "--block", "2,1"}),
                 HasSubstr("frames of a strip = 1, must be in [2, 99]"));
  EXPECT_REFUSED(run({"simulate", "--out", "s", "--block", "30,3"}),
                 AllOf(HasSubstr("two frames of each strip of the block show"),
                       HasSubstr("must be 40 to 2000 m each")));
  EXPECT_REFUSED(simulate("s", {"--forward-overlap", "0.3"}), HasSubstr("--forward-overlap"));
  EXPECT_REFUSED(simulate("s", {"--side-overlap", "0"}),
                 AllOf(HasSubstr("m from the corner of the plan"), HasSubstr("must be 2 or more")));
  EXPECT_FALSE(fs::exists(path("s")));
}

}  // namespace
}  // namespace ridgeline::cli
