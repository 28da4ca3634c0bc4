// SPDX-License-Identifier: BSD-3-Clause
// What the keys of a block and of its patches hold: poses and cameras from whatever file, heights.
#include "apps/block/plan_block.h"
#include "apps/pipeline/made_from.h"
#include "apps/simulate/write_orientation.h"
#include "io/images/image_writer.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include <filesystem>

namespace ridgeline::apps {
namespace {

namespace fs = std::filesystem;

/// Two small frames over flat land.
class PlanKey : public testing::Test {
 protected:
  PlanKey() {
    cv::Mat picture(30, 40, CV_8UC1);
    cv::randu(picture, 0, 255);
    for (const char* name : {"a.tif", "b.tif"}) io::write_tiff(folder_.file(name), picture);
  }

  static io::Orientation orientation(double moved_m, double focal_length_px) {
    io::Orientation two;
    two.crs.definition = "EPSG:25832";
    two.ground_height_m = 0.0;
    two.cameras.push_back(
        {"frame", {{focal_length_px, focal_length_px}, {19.5, 14.5}, {}, Eigen::Vector2i(40, 30)}});
    for (const auto& [name, x_m] : {std::pair("a.tif", 0.0), std::pair("b.tif", 30.0)}) {
      const Eigen::Vector3d place_m(500000.0 + x_m + moved_m, 5400000.0, 100.0);
      two.images.push_back({name, 0, {place_m, world_from_camera_axes(0.01, -0.01, 0.3)}});
    }
    return two;
  }

  [[nodiscard]] io::BlockFile block(const std::string& more) const {
    return read_block(folder_.write("block.yaml",
                                    "block: b\ncrs: EPSG:25832\nimages: '*.tif'\n"
                                    "area: [500000, 5399980, 500040, 5400020]\n" +
                                        more));
  }

  io::TempFolder folder_;
};

class PlanKeyOfFormat : public PlanKey, public testing::WithParamInterface<const char*> {};

TEST_P(PlanKeyOfFormat, ChangesWithEachFileOfTheOrientation) {
  const simulate::OrientationFiles files = simulate::orientation_files(GetParam());
  const auto read = [&] {
    return block(fmt::format("height_range: [0, 10]\norientation: {}\n{}{}", files.orientation,
                             files.cameras.empty() ? "" : "cameras: " + files.cameras + "\n",
                             files.matrix.empty() ? "" : "matrix: " + files.matrix + "\n"));
  };
  const auto write = [&](const std::string& folder, double moved_m, double focal_length_px) {
    fs::create_directories(fs::path(folder_.file(folder)) / "colmap");
    simulate::write_orientation(folder_.file(folder), GetParam(),
                                orientation(moved_m, focal_length_px));
  };
  write(".", 0.0, 40.0);
  write("mended", 1000.0, 41.0);
  std::string key = key_of_plan(read(), {});
  EXPECT_EQ(key_of_plan(read(), {}), key);
  int n_mended = 0;
  for (const std::string& file : files.files) {
    if (folder_.read(file) == folder_.read("mended/" + file)) continue;
    fs::copy_file(folder_.file("mended/" + file), folder_.file(file),
                  fs::copy_options::overwrite_existing);
    const std::string mended = key_of_plan(read(), {});
    EXPECT_NE(mended, key) << file;
    key = mended;
    ++n_mended;
  }
  EXPECT_GE(n_mended, 1);
}

INSTANTIATE_TEST_SUITE_P(
    AllFormats,
    PlanKeyOfFormat,
    testing::Values(
        "opk", "opensfm", "pix4d", "inpho", "pat_b", "blocks_exchange", "metashape", "colmap"),
    [](const auto& format) { return std::string(format.param); });

TEST_F(PlanKey, ChangesWithAFileBesideTheSurfaceModel) {
  simulate::write_orientation(folder_.file("."), "opk", orientation(0.0, 40.0));
  (void)folder_.write("model.asc",
                      "ncols 2\nnrows 2\nxllcorner 500000\nyllcorner 5399980\ncellsize 20\n"
                      "1 2\n3 4\n");
  const auto key = [&] {
    const io::BlockFile read = block(
        "height_range: auto\nsurface_model: model.asc\norientation: opk.csv\n"
        "cameras: cameras.yaml\n");
    return key_of_plan(read, planned_inputs(read));
  };
  const std::string without = key();
  EXPECT_EQ(key(), without);
  const io::Crs crs{.definition = "EPSG:25832"};
  (void)folder_.write("model.prj", io::to_wkt(crs));
  EXPECT_NE(key(), without);
}

TEST_F(PlanKey, OfThePictureIsWithoutThePose) {
  simulate::write_orientation(folder_.file("."), "opk", orientation(0.0, 40.0));
  const std::string keys = "height_range: [0, 10]\norientation: opk.csv\ncameras: cameras.yaml\n";
  const io::PatchImage before = block(keys).images.front();
  simulate::write_orientation(folder_.file("."), "opk", orientation(0.5, 40.0));
  const io::PatchImage after = block(keys).images.front();
  EXPECT_EQ(key_of_picture(before, "hash"), key_of_picture(after, "hash"));
  EXPECT_NE(key_of_view(before, "hash"), key_of_view(after, "hash"));
  EXPECT_NE(key_of_picture(before, "hash"), key_of_picture(before, "another"));
}

}  // namespace
}  // namespace ridgeline::apps
