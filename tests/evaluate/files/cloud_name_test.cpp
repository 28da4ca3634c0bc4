// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/cloud_name.h"

#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace ridgeline::results {
namespace {

const std::string kSamples = std::filesystem::path(test::source_dir()) / "sample_data";

TEST(CloudName, OfOneFileIsItsNameWithoutExtension) {
  EXPECT_EQ(cloud_name({kSamples + "/1/lidar.las"}), "lidar");
}

TEST(CloudName, OfSeveralIsTheDeepestFolderThatHoldsThem) {
  EXPECT_EQ(cloud_name({kSamples + "/1/lidar.las", kSamples + "/2/lidar.las"}), "sample_data");
}

TEST(CloudName, OfAPatternLeavesOutTheFoldersThatItLeavesOpen) {
  EXPECT_EQ(cloud_name({kSamples + "/1/*.las"}), "1");
  EXPECT_EQ(cloud_name({kSamples + "/*/lidar.las"}), "sample_data");
}

TEST(CloudName, OfFilesThatTheRootAloneHoldsIsCloud) {
  EXPECT_EQ(cloud_name({"/a/x.las", "/b/x.las"}), "cloud");
}

}  // namespace
}  // namespace ridgeline::results
