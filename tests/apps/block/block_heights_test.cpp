// SPDX-License-Identifier: BSD-3-Clause
#include "apps/block/block_heights.h"

#include "apps/pipeline/area_heights.h"
#include "io/error.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace ridgeline::apps {
namespace {

using testing::HasSubstr;

/// Cells of 1 m in a square of 20 m with heights of 50 m in the east and a value in the west.
std::string model(const std::string& west, const std::string& more = "") {
  std::string text = "ncols 20\nnrows 20\nxllcorner 0\nyllcorner 0\ncellsize 1\n" + more;
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 20; ++column) text += (column < 10 ? west : "50") + " ";
    text += "\n";
  }
  return text;
}

Eigen::AlignedBox2d strip(double from_m, double to_m) {
  return {Eigen::Vector2d(from_m, 0.0), Eigen::Vector2d(to_m, 20.0)};
}

/// The expected range has the margin of height_range_m().
constexpr std::array kRange_m{50.0 - kHeightMargin_m, 50.0 + kHeightMargin_m};

TEST(BlockHeights, WithoutHeightsInAnAreaAreThoseOfTheBlockWhetherNodataIsStatedOrNot) {
  const io::TempFolder folder;
  io::BlockFile block;
  block.path = "block.yaml";
  for (const bool is_stated : {true, false}) {
    block.surface_model =
        folder.write("dsm.asc", model("-9999", is_stated ? "NODATA_value -9999\n" : ""));
    const BlockHeights heights(block);
    EXPECT_EQ(heights.range_m(strip(0.0, 9.0)), std::nullopt);
    EXPECT_EQ(heights.range_m(strip(5.0, 15.0)), kRange_m);
    EXPECT_EQ(heights.whole_range_m(), kRange_m);
    EXPECT_EQ(heights.warning().has_value(), !is_stated);
    EXPECT_THAT(heights.warning().value_or("200 of 400 heights of "),
                HasSubstr("200 of 400 heights of "));
  }
}

TEST(BlockHeights, WithoutAnyHeightAreAnError) {
  const io::TempFolder folder;
  io::BlockFile block;
  block.surface_model = folder.write("dsm.asc", model("50"));
  block.area_m = {{100.0, 0.0}, {120.0, 0.0}, {120.0, 20.0}, {100.0, 20.0}};
  EXPECT_THROW(BlockHeights{block}, io::IoError);
}

TEST(BlockHeights, OfLidarLeaveOutThoseThatNoSurfaceHas) {
  const io::TempFolder folder;
  std::string points;
  for (int i = 0; i < 400; ++i)
    points += fmt::format("{} {} {}\n", i % 20, i / 20, i % 9 == 0 ? -9999 : 50);
  io::BlockFile block;
  block.path = "block.yaml";
  block.lidar = {folder.write("lidar.xyz", points)};
  const BlockHeights heights(block);
  EXPECT_EQ(heights.whole_range_m(), kRange_m);
  EXPECT_EQ(heights.range_m(strip(0.0, 20.0)), kRange_m);
  EXPECT_EQ(heights.range_m(strip(100.0, 120.0)), std::nullopt);
  EXPECT_THAT(heights.warning().value_or(""), HasSubstr("45 of 400 heights of LIDAR points"));
}

}  // namespace
}  // namespace ridgeline::apps
