// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/image_writer.h"

#include "io/error.h"
#include "io/images/image.h"
#include "tests/support/temp_folder.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
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

TEST(TiffWriter, GivesTheBytesOfOneCallWhateverTheRowsAtOnce) {
  const TempFolder folder;
  const cv::Mat image = pattern(CV_16UC3);
  write_tiff(folder.file("whole.tif"), image);
  TiffWriter writer(folder.file("parts.tif"), image.size(), image.type(), TiffLayout::kStrips);
  for (int row = 0; row < image.rows; row += 5) {
    writer.write_rows(image.rowRange(row, std::min(row + 5, image.rows)));
  }
  writer.commit();
  EXPECT_TRUE(folder.read("whole.tif") == folder.read("parts.tif"));
}

cv::Mat tall_pattern() {
  cv::Mat image(2 * kTile_px + 90, kTile_px + 47, CV_8UC3);
  for (int row = 0; row < image.rows; ++row) {
    for (int i = 0; i < 3 * image.cols; ++i) {
      image.ptr<std::uint8_t>(row)[i] = static_cast<std::uint8_t>(31 * row + 7 * i);
    }
  }
  return image;
}

void write_in_tiles(const std::string& path, const cv::Mat& image) {
  TiffWriter writer(path, image.size(), image.type(), TiffLayout::kTiles);
  for (int row = 0; row < image.rows; row += kTile_px) {
    writer.write_rows(image.rowRange(row, std::min(row + kTile_px, image.rows)));
  }
  writer.commit();
}

TEST(TiffWriter, WritesTilesOfWhichAWindowIsReadAlone) {
  const TempFolder folder;
  const cv::Mat image = tall_pattern();
  write_in_tiles(folder.file("tiles.tif"), image);
  const cv::Mat read = read_image(folder.file("tiles.tif"));
  ASSERT_EQ(read.size(), image.size());
  EXPECT_TRUE(std::equal(image.datastart, image.dataend, read.datastart));
  const GDALDatasetUniquePtr dataset(
      GDALDataset::Open(folder.file("tiles.tif").c_str(), GDAL_OF_RASTER));
  ASSERT_NE(dataset, nullptr);
  int width = 0;
  int height = 0;
  dataset->GetRasterBand(1)->GetBlockSize(&width, &height);
  EXPECT_EQ(width, kTile_px);
  EXPECT_EQ(height, kTile_px);
  // the tiles with their margins and one header of less than a tile
  constexpr std::size_t kTile_bytes = std::size_t{3} * kTile_px * kTile_px;
  EXPECT_EQ(folder.read("tiles.tif").size() / kTile_bytes, 6U);
}

/// Files of this process end at a size while it lives.
class LargestFile {
 public:
  explicit LargestFile(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~LargestFile() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  LargestFile(const LargestFile&) = delete;
  LargestFile& operator=(const LargestFile&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

/// It has as many bytes when it is compressed.
cv::Mat noise() {
  cv::Mat image(600, 600, CV_8UC3);
  cv::randu(image, cv::Scalar::all(0), cv::Scalar::all(255));
  return image;
}

TEST(TiffWriter, LeavesNothingWithoutCommitAndWhereTheDiskIsFull) {
  const TempFolder folder;
  const cv::Mat image = tall_pattern();
  {
    TiffWriter writer(folder.file("a.tif"), image.size(), image.type(), TiffLayout::kTiles);
    writer.write_rows(image.rowRange(0, kTile_px));
    EXPECT_THROW(writer.commit(), std::invalid_argument);
  }
  {
    const LargestFile limit(300000);
    EXPECT_THROW(write_in_tiles(folder.file("a.tif"), image), IoError);
    EXPECT_THROW(write_tiff(folder.file("a.tif"), noise()), IoError);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.file("")));
}

TEST(TiffWriter, RefusesRowsThatAreNotTheNextOnes) {
  const TempFolder folder;
  const cv::Mat image = tall_pattern();
  TiffWriter writer(folder.file("a.tif"), image.size(), image.type(), TiffLayout::kTiles);
  EXPECT_THROW(writer.write_rows(image.colRange(0, 9)), std::invalid_argument);
  EXPECT_THROW(writer.write_rows(image.rowRange(0, 9)), std::invalid_argument);
  writer.write_rows(image);
  EXPECT_THROW(writer.write_rows(image.rowRange(0, 1)), std::invalid_argument);
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
