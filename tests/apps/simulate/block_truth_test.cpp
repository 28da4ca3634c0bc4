// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/block_truth.h"

#include "apps/simulate/block_flight.h"
#include "apps/simulate/visible_runs.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace ridgeline::simulate {
namespace {

/// Six frames of 90 x 80 m, of which some show the house of the scene and some do not.
std::vector<AerialView> frames_around(const SyntheticScene& scene) {
  FlightOptions flight;
  flight.frame_px = Eigen::Vector2i(900, 800);
  flight.focal_length_px = 2000.0;
  flight.height_above_ground_m = 200.0;
  BlockOptions block;
  block.num_frames = 5;
  return aerial_views(scene, flight, block_views(block, flight, scene));
}

TEST(SeenInBlock, CountsTheViewsThatSeeHalfOfALineAsWithoutALookAtTheFrames) {
  const SyntheticScene scene = test::gabled_house(35.0, 20.0);
  const std::vector<AerialView> frames = frames_around(scene);
  const io::LineSet truth = seen_in_block(scene, frames, true_lines(scene));
  const auto shares = visible_shares(scene, SurfaceOracle(scene, frames));
  ASSERT_EQ(truth.lines.size(), shares.size());
  std::size_t most = 0;
  std::size_t fewest = frames.size();
  for (std::size_t i = 0; i < shares.size(); ++i) {
    std::vector<double> sorted = shares[i];
    std::ranges::sort(sorted, std::greater());
    const auto n_images = static_cast<std::size_t>(
        std::ranges::count_if(sorted, [](double share) { return share >= 0.5; }));
    EXPECT_EQ(truth.lines[i].n_images, static_cast<int>(n_images)) << i;
    EXPECT_EQ(truth.lines[i].visible_base, sorted[0]) << i;
    EXPECT_EQ(truth.lines[i].visible_other, sorted[1]) << i;
    most = std::max(most, n_images);
    fewest = std::min(fewest, n_images);
  }
  EXPECT_LT(most, frames.size());  // not all frames show the house
  EXPECT_GT(most, 3U);
  EXPECT_LT(fewest, most);
}

TEST(SeenInBlock, ClassesALineByTheViewsThatSeeIt) {
  const SyntheticScene scene = test::gabled_house(35.0, 0.0);
  std::vector<AerialView> frames = frames_around(scene);
  std::erase_if(frames, [](const AerialView& frame) { return frame.id.starts_with("02"); });
  for (const io::Line& line : seen_in_block(scene, frames, true_lines(scene)).lines) {
    if (line.kind != "ridge" && line.kind != "verge") continue;
    EXPECT_EQ(line.line_class, line.kind == "ridge" ? "aligned" : "not_aligned");
  }
}

TEST(SeenInBlock, KeepsTheClassOfALineThatOneViewSees) {
  const SyntheticScene scene = test::gabled_house(35.0, 0.0);
  const std::vector<AerialView> frames = frames_around(scene);
  io::LineSet truth = true_lines(scene);
  for (io::Line& line : truth.lines) line.line_class = "as before";
  truth = seen_in_block(scene, std::vector{frames[0], frames[2]}, std::move(truth));
  for (const io::Line& line : truth.lines) {
    EXPECT_LE(line.n_images, 1);
    EXPECT_EQ(line.line_class, "as before");
  }
}

TEST(SeenInBlock, RefusesOneViewAndLinesOfAnotherScene) {
  const SyntheticScene scene = test::gabled_house(35.0, 0.0);
  const std::vector<AerialView> frames = frames_around(scene);
  EXPECT_THROW((void)seen_in_block(scene, std::vector{frames[0]}, true_lines(scene)),
               std::invalid_argument);
  EXPECT_THROW((void)seen_in_block(scene, frames, {}), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::simulate
