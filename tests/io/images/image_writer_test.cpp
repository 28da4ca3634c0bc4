// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/image_writer.h"

#include "io/error.h"
#include "io/images/image.h"
#include "tests/support/temp_folder.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <cstdint>
#include <filesystem>

namespace ridgeline::io {
namespace {

cv::Mat pattern(int type) {
  cv::Mat image(37, 53, type);
  for (int row = 0; row < image.rows; ++row) {
    for (int i = 0; i < image.cols * image.channels(); ++i) {
      const int value = 7919 * row + 104729 * i;
      if (image.depth() == CV_8U) {
        image.ptr<std::uint8_t>(row)[i] = static_cast<std::uint8_t>(value);
      } else {
        image.ptr<std::uint16_t>(row)[i] = static_cast<std::uint16_t>(value);
      }
    }
  }
  return image;
}

TEST(WriteTiff, IsReadBackWithoutLossAtBothDepthsAndAllBands) {
  const TempFolder folder;
  const std::string path = folder.file("image.tif");
  for (const int depth : {CV_8U, CV_16U}) {
    for (int bands = 1; bands <= 4; ++bands) {
      const cv::Mat image = pattern(CV_MAKETYPE(depth, bands));
      write_tiff(path, image);
      const cv::Mat read = read_image(path);
      ASSERT_EQ(read.type(), image.type());
      ASSERT_EQ(read.size(), image.size());
      EXPECT_TRUE(std::equal(image.datastart, image.dataend, read.datastart));
    }
  }
}

TEST(WriteTiff, WritesThePartThatAViewShows) {
  const TempFolder folder;
  const cv::Mat image = pattern(CV_8UC3);
  const cv::Mat part = image(cv::Rect(5, 6, 20, 10));  // rows are not contiguous
  write_tiff(folder.file("part.tif"), part);
  const cv::Mat read = read_image(folder.file("part.tif"));
  ASSERT_EQ(read.size(), part.size());
  EXPECT_EQ(read.at<cv::Vec3b>(9, 19), part.at<cv::Vec3b>(9, 19));
}

TEST(WriteTiff, RefusesOtherTypesAndPlaces) {
  const TempFolder folder;
  EXPECT_THROW(write_tiff(folder.file("a.tif"), cv::Mat()), std::invalid_argument);
  EXPECT_THROW(write_tiff(folder.file("a.tif"), cv::Mat(2, 2, CV_32FC1, cv::Scalar(0))),
               std::invalid_argument);
  EXPECT_THROW(write_tiff("/proc/none/a.tif", pattern(CV_8UC1)), IoError);
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.tif")));
}

}  // namespace
}  // namespace ridgeline::io
