// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/open_patch.h"

#include "io/error.h"
#include "io/images/image_writer.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace ridgeline::apps {
namespace {

/// Two cameras 800 m above the ground that look down, 0.1 m a pixel, 50 m beside each other.
constexpr const char* kTwoImages =
    "id: 7\ncrs: EPSG:25832\nheight_range: [0, 20]\nimages:\n"
    "  - {id: a, path: a.tif, projection_matrix: "
    "[[8000,0,-20,-4104016000],[0,-8000,-15,43216012000],[0,0,-1,800]]}\n"
    "  - {id: b, path: b.tif, projection_matrix: "
    "[[8000,0,-20,-4104416000],[0,-8000,-15,43216012000],[0,0,-1,800]]}\n";

class OpenPatch : public testing::Test {
 protected:
  OpenPatch() : file_(folder_.write("patch.yaml", kTwoImages)) {}

  void write_images() const {
    const cv::Mat picture(30, 40, CV_8UC1, cv::Scalar(100));
    for (const char* name : {"a.tif", "b.tif"}) io::write_tiff(folder_.file(name), picture);
  }

  io::TempFolder folder_;
  std::string file_;
};

TEST_F(OpenPatch, HasItsHeightsItsFrameAndTheCrsOfTheUser) {
  write_images();
  const io::Patch patch = open_patch(file_, {.assume_crs = {"EPSG:25833"}});
  EXPECT_EQ(patch.height_range_m, (std::array{0.0, 20.0}));
  EXPECT_EQ(patch.frame.origin_m, Eigen::Vector3d(513000.0, 5402000.0, 0.0));
  EXPECT_EQ(patch.crs.definition, "EPSG:25833");
  EXPECT_FALSE(patch.images_are_chosen);
}

TEST_F(OpenPatch, SaysWhatWasDecidedBeforeItFails) {
  int n_told = 0;
  EXPECT_THROW((void)open_patch(file_, {}, [&](const io::Patch&) { ++n_told; }), io::IoError);
  EXPECT_EQ(n_told, 1);
  write_images();
  EXPECT_THROW((void)open_patch(file_, {.max_image_mpx = 1e-4}), io::IoError);
}

TEST_F(OpenPatch, IsReadWithoutItsImages) {
  const io::Patch patch = read_patch(file_);
  EXPECT_EQ(patch.frame.origin_m, Eigen::Vector3d(513000.0, 5402000.0, 0.0));
  EXPECT_EQ(patch.images.size(), 2U);
}

}  // namespace
}  // namespace ridgeline::apps
