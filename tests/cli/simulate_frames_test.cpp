// SPDX-License-Identifier: BSD-3-Clause
// Whole frames, and orientations in place of matrices.
#include "io/images/image.h"
#include "io/project/patch.h"
#include "tests/cli/cli_fixture.h"

#include <Eigen/LU>

#include <algorithm>

namespace ridgeline::cli {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

class SimulateFrames : public Cli {
 protected:
  [[nodiscard]] ProgramResult simulate(const std::string& out,
                                       const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"simulate", "--out",
                                       out,        "--seed",
                                       "3",        "--extent-m",
                                       "45,45",    "--samples-per-side",
                                       "1",        "--focal-length-px",
                                       "4000"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  /// Frames of 0.2 m a pixel, small ones.
  [[nodiscard]] ProgramResult simulate_frames(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"--frame-px", "700,600", "--base-to-height", "0.08"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return simulate("frames", arguments);
  }
};

/// The largest distance of the pixels at which two cameras see the corners of the first one's image
/// on a plane.
double largest_px(const io::PatchImage& a, const io::PatchImage& b) {
  const io::ImageFacts facts = io::image_facts(a.path);
  const Eigen::Vector3d centre = projection_centre(a.image_from_world).hnormalized();
  const Eigen::Matrix3d ray_from_pixel = a.image_from_world.leftCols<3>().inverse();
  double largest = 0.0;
  for (const double column : {0.0, facts.width_px - 1.0}) {
    for (const double row : {0.0, facts.height_px - 1.0}) {
      const Eigen::Vector2d x_px(column, row);
      const Eigen::Vector3d ray = ray_from_pixel * x_px.homogeneous();
      const Eigen::Vector3d x = centre + (250.0 - centre.z()) / ray.z() * ray;
      largest = std::max(largest,
                         (project(b.image_from_world, x) - project(a.image_from_world, x)).norm());
    }
  }
  return largest;
}

/// A table, one without cameras that needs a word, and one with poses on the Earth;
/// write_orientation_test.cpp has all.
TEST_F(SimulateFrames, APatchWithAnOrientationHasTheCamerasOfTheMatrices) {
  constexpr double kTolPx = 1e-5;  // of poses that lie on the Earth; see write_orientation_test.cpp
  ASSERT_EQ(simulate("matrices", {}).exit_code, 0);
  const io::PatchFile matrices = io::read_patch(path("matrices/patch.yaml").string());
  for (const char* format : {"opk", "pat_b", "metashape"}) {
    SCOPED_TRACE(format);
    const ProgramResult made = simulate(format, {"--orientation", format});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_TRUE(read(path(format) / "left.tif") == read(path("matrices/left.tif")));
    EXPECT_TRUE(read(path(format) / "matches.csv") == read(path("matrices/matches.csv")));
    EXPECT_THAT(read(path(format) / "patch.yaml"),
                AllOf(HasSubstr("orientation: "), Not(HasSubstr("projection_matrix")),
                      HasSubstr("  - path: left.tif\n  - path: right.tif\n")));
    const io::PatchFile patch = io::read_patch((path(format) / "patch.yaml").string());
    ASSERT_EQ(patch.images.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(patch.images[i].id, matrices.images[i].id);
      EXPECT_LT(largest_px(matrices.images[i], patch.images[i]), kTolPx);
    }
  }
}

TEST_F(SimulateFrames, AreTiledAndNamedWithTheAreaOfTheVillage) {
  const ProgramResult made =
      simulate_frames({"--orientation", "blocks_exchange", "--views", "strip:2,cross:1"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(names_in(path("frames")), IsSupersetOf({"blocks_exchange.xml", "cross1.tif",
                                                      "strip1.tif", "strip2.tif", "tracks.csv"}));
  EXPECT_THAT(
      read(path("frames/patch.yaml")),
      AllOf(HasSubstr("area: [513002, 5403002, 513043, 5403043]\n"),
            HasSubstr("orientation: blocks_exchange.xml\n"), HasSubstr("  - path: cross1.tif\n")));
  const io::ImageFacts facts = io::image_facts(path("frames/cross1.tif").string());
  EXPECT_EQ(facts.width_px, 700);
  EXPECT_EQ(facts.height_px, 600);
  const ProgramResult info = run({"info", "frames/blocks_exchange.xml"});
  EXPECT_EQ(info.exit_code, 0) << info.err;
  EXPECT_THAT(info.out, AllOf(HasSubstr("BlocksExchange"), HasSubstr("700 x 600")));
  EXPECT_THAT(read_json(path("frames/simulate.json"))["files"].dump(),
              HasSubstr("blocks_exchange.xml"));
}

TEST_F(SimulateFrames, AreTheSameForAnyNumberOfThreadsAndWrittenOverByTheNext) {
  ASSERT_EQ(simulate_frames({"--orientation", "colmap", "--jobs", "1"}).exit_code, 0);
  const auto first = results_in("frames");
  const ProgramResult again = simulate_frames({"--orientation", "colmap", "--jobs", "2"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(results_in("frames"), first);
  EXPECT_TRUE(std::filesystem::exists(path("frames/colmap/images.txt")));
}

TEST_F(SimulateFrames, HaveTheirTrueMatchesInPixelsOfTheFrame) {
  ASSERT_EQ(simulate_frames({}).exit_code, 0);
  std::istringstream rows(read(path("frames/matches.csv")));
  std::string row;
  std::getline(rows, row);
  int n_matches = 0;
  while (std::getline(rows, row)) ++n_matches;
  EXPECT_GT(n_matches, 20);
  const ProgramResult result =
      run({"run", "frames/patch.yaml", "--out", "out", "--methods", "joint", "--no-report"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_LT(read_json(path("out/run.json"))["windows_px"]["frames"]["left"][2].get<int>(), 400);
  const nlohmann::json table = read_json(path("out/table1.json"))["rows"][0];
  EXPECT_GT(table["correct"].get<int>(), 10) << table;
  EXPECT_LT(table["false"].get<int>(), 3) << table;
}

TEST_F(SimulateFrames, WrongOnesAreRefusedWithTheOptionTheValueAndTheRule) {
  EXPECT_REFUSED(simulate("s", {"--frame-px", "50,600"}),
                 AllOf(HasSubstr("--frame-px"), HasSubstr("must be in [100, 30000]")));
  EXPECT_REFUSED(simulate("s", {"--frame-px", "7680"}), HasSubstr("--frame-px"));
  EXPECT_REFUSED(simulate("s", {"--frame-px", "7680,x"}), HasSubstr("--frame-px"));
  EXPECT_REFUSED(simulate("s", {"--frame-px", "29000,29000"}), HasSubstr("300 megapixels"));
  EXPECT_REFUSED(simulate("s", {"--frame-px", "400,400"}), HasSubstr("the middle of the plan"));
  EXPECT_REFUSED(simulate("s", {"--frame-px", "7680,13824", "--geometry", "chio_wang_2000"}),
                 AllOf(HasSubstr("--frame-px and --geometry"), HasSubstr("both")));
  EXPECT_REFUSED(simulate("s", {"--frame-px", "7680,13824", "--views", "strip:31"}),
                 HasSubstr("must have 1 to 30 views"));
  EXPECT_REFUSED(simulate("s", {"--frame-px", "7680,13824", "--no-images"}),
                 AllOf(HasSubstr("--frame-px"), HasSubstr("--no-images")));
  EXPECT_REFUSED(simulate("s", {"--orientation", "pix4"}),
                 AllOf(HasSubstr("--orientation"), HasSubstr("the nearest is pix4d")));
  EXPECT_FALSE(std::filesystem::exists(path("s")));
}

}  // namespace
}  // namespace ridgeline::cli
