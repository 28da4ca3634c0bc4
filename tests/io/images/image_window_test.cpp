// SPDX-License-Identifier: BSD-3-Clause
#include "io/error.h"
#include "io/images/image.h"
#include "tests/support/temp_folder.h"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include <array>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace ridgeline::io {
namespace {

using testing::HasSubstr;

/// Smooth values, so that lossy formats keep them nearly, with a wave that tells all places apart.
cv::Mat wavy_image(const cv::Size& size, int n_bands, int bits) {
  cv::Mat image(size, CV_MAKETYPE(bits == 8 ? CV_8U : CV_16U, n_bands));
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      for (int band = 0; band < n_bands; ++band) {
        const double value =
            0.5 + 0.2 * std::sin(0.11 * x + band) + 0.2 * std::cos(0.07 * y - band);
        if (bits == 8) {
          image.ptr<std::uint8_t>(y)[x * n_bands + band] = static_cast<std::uint8_t>(255 * value);
        } else {
          image.ptr<std::uint16_t>(y)[x * n_bands + band] =
              static_cast<std::uint16_t>(4095 * value);
        }
      }
    }
  }
  return image;
}

/// How a file is written.
struct Storage {
  const char* name;
  const char* driver;
  std::vector<const char*> options;
  std::vector<int> bands, bits;
};

GDALDatasetUniquePtr in_memory(const cv::Mat& image) {
  GDALAllRegister();
  const GDALDataType type = image.depth() == CV_8U ? GDT_Byte : GDT_UInt16;
  GDALDatasetUniquePtr memory(GetGDALDriverManager()->GetDriverByName("MEM")->Create(
      "", image.cols, image.rows, image.channels(), type, nullptr));
  const auto size = static_cast<GSpacing>(image.elemSize1());
  EXPECT_EQ(memory->RasterIO(GF_Write, 0, 0, image.cols, image.rows, image.data, image.cols,
                             image.rows, type, image.channels(), nullptr, size * image.channels(),
                             static_cast<GSpacing>(image.step[0]), size, nullptr),
            CE_None);
  return memory;
}

/// Copies a dataset to a file; false if this GDAL cannot write it so.
bool copy_to(const std::string& path, const Storage& storage, GDALDataset& dataset) {
  CPLStringList options;
  for (const char* option : storage.options) options.AddString(option);
  CPLPushErrorHandler(CPLQuietErrorHandler);
  const GDALDatasetUniquePtr copy(
      GetGDALDriverManager()
          ->GetDriverByName(storage.driver)
          ->CreateCopy(path.c_str(), &dataset, 0, options.List(), nullptr, nullptr));
  CPLPopErrorHandler();
  return copy != nullptr;
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

const std::vector<Storage>& storages() {
  static const std::vector<Storage> all{
      {"tiles", "GTiff", {"TILED=YES", "BLOCKXSIZE=64", "BLOCKYSIZE=64"}, {1, 2, 3, 4}, {8, 16}},
      {"strips", "GTiff", {"BLOCKYSIZE=16", "COMPRESS=DEFLATE"}, {1, 3, 4}, {8, 16}},
      {"one strip", "GTiff", {"BLOCKYSIZE=190", "COMPRESS=LZW"}, {3}, {8}},
      {"planes", "GTiff", {"INTERLEAVE=BAND", "TILED=YES"}, {3, 4}, {8, 16}},
      {"BigTIFF", "GTiff", {"BIGTIFF=YES", "TILED=YES"}, {3}, {8, 16}},
      {"JPEG in TIFF", "GTiff", {"COMPRESS=JPEG", "TILED=YES", "PHOTOMETRIC=YCBCR"}, {3}, {8}},
      {"12 bit", "GTiff", {"NBITS=12", "TILED=YES", "COMPRESS=DEFLATE"}, {1, 4}, {16}},
      {"COG", "COG", {"BLOCKSIZE=128"}, {1, 3, 4}, {8, 16}},
      {"JPEG 2000", "JP2OpenJPEG", {"REVERSIBLE=YES", "QUALITY=100"}, {1, 3, 4}, {8, 16}},
      {"JPEG", "JPEG", {}, {1, 3}, {8}},
      {"PNG", "PNG", {}, {1, 3, 4}, {8, 16}}};
  return all;
}

TEST(ReadPicture, WindowOfEveryFormatHasThePixelsOfTheWholeImage) {
  const TempFolder folder;
  const std::string path = folder.file("image");
  const Window window{37, 41, 90, 77};
  const cv::Rect area(window.column, window.row, window.width, window.height);
  for (const Storage& storage : storages()) {
    for (const int bits : storage.bits) {
      for (const int bands : storage.bands) {
        SCOPED_TRACE(fmt::format("{}, {} bands of {} bits", storage.name, bands, bits));
        ASSERT_TRUE(copy_to(path, storage, *in_memory(wavy_image({210, 190}, bands, bits))));
        const cv::Mat whole = read_picture(path).pixels;
        EXPECT_EQ(whole.channels(), bands);
        EXPECT_TRUE(same(read_picture(path, {.window = window}).pixels, whole(area)));
      }
    }
  }
}

TEST(ReadPicture, WindowThatIsNotWithinTheImageIsRefused) {
  const TempFolder folder;
  const std::string path = folder.file("image.tif");
  ASSERT_TRUE(copy_to(path, storages()[0], *in_memory(wavy_image({60, 50}, 1, 8))));
  for (const Window& window : {Window{-1, 0, 10, 10}, Window{0, 41, 10, 10}, Window{55, 0, 10, 10},
                               Window{2147483600, 0, 100, 10}, Window{0, 0, 61, 50}}) {
    EXPECT_THROW((void)read_picture(path, {.window = window}), IoError);
  }
  EXPECT_THROW((void)read_picture(path, {.window = Window{0, 0, 1, 50}}), IoError);
}

TEST(ReadPicture, SampleIsTheWholeOfASmallImageAndOneOfALargeOneWhateverTheWindow) {
  const TempFolder folder;
  const std::string tiles = folder.file("tiles.tif");
  const std::string strips = folder.file("strips.tif");
  const cv::Mat small = wavy_image({300, 200}, 3, 8);
  ASSERT_TRUE(copy_to(tiles, storages()[0], *in_memory(small)));
  EXPECT_TRUE(same(read_picture(tiles, {.window = Window{0, 0, 20, 20}}).sample,
                   small.reshape(0, 300 * 200)));
  const cv::Mat large = wavy_image({1500, 1100}, 1, 16);
  ASSERT_TRUE(copy_to(tiles, storages()[0], *in_memory(large)));
  ASSERT_TRUE(copy_to(strips, storages()[1], *in_memory(large)));
  const cv::Mat sample = read_picture(tiles).sample;
  EXPECT_EQ(sample.size(), cv::Size(1, 256 * 64 * 64));
  EXPECT_TRUE(same(read_picture(tiles, {.window = Window{900, 800, 90, 50}}).sample, sample));
  EXPECT_TRUE(same(read_picture(strips, {.window = Window{5, 5, 30, 20}}).sample, sample));
}

TEST(ReadPicture, NodataInAllBandsAndMasksAreNoData) {
  const TempFolder folder;
  const std::string path = folder.file("image.tif");
  cv::Mat image = wavy_image({80, 60}, 3, 8);
  image(cv::Rect(0, 0, 20, 60)).setTo(cv::Scalar::all(0));
  image.at<cv::Vec3b>(30, 40) = {0, 0, 7};  // dark, but it has data
  const GDALDatasetUniquePtr memory = in_memory(image);
  ASSERT_TRUE(copy_to(path, storages()[0], *memory));
  EXPECT_TRUE(read_picture(path).is_valid.empty());
  for (int band = 1; band <= 3; ++band) memory->GetRasterBand(band)->SetNoDataValue(0.0);
  ASSERT_TRUE(copy_to(path, storages()[0], *memory));
  const Picture picture = read_picture(path);
  EXPECT_EQ(cv::countNonZero(picture.is_valid), 60 * 60);
  EXPECT_EQ(picture.is_valid.at<std::uint8_t>(30, 19), 0);
  EXPECT_NE(picture.is_valid.at<std::uint8_t>(30, 40), 0);
  EXPECT_EQ(picture.sample.rows, 60 * 60);
  EXPECT_TRUE(read_picture(path, {.window = Window{20, 0, 60, 60}}).is_valid.empty());
}

TEST(ReadPicture, MaskOfTheFileIsRespected) {
  const TempFolder folder;
  const std::string path = folder.file("image.tif");
  const GDALDatasetUniquePtr memory = in_memory(wavy_image({80, 60}, 1, 16));
  ASSERT_EQ(memory->CreateMaskBand(GMF_PER_DATASET), CE_None);
  cv::Mat mask(60, 80, CV_8UC1, cv::Scalar(255));
  mask(cv::Rect(0, 0, 80, 25)).setTo(0);
  GDALRasterBand& band = *memory->GetRasterBand(1)->GetMaskBand();
  ASSERT_EQ(band.RasterIO(GF_Write, 0, 0, 80, 60, mask.data, 80, 60, GDT_Byte, 0, 0, nullptr),
            CE_None);
  CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", "YES");
  ASSERT_TRUE(copy_to(path, storages()[0], *memory));
  CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", nullptr);
  EXPECT_TRUE(same(read_picture(path).is_valid, mask));
}

TEST(ReadPicture, TurnedWindowIsThatOfTheTurnedImage) {
  const TempFolder folder;
  const std::string path = folder.file("image.tif");
  const cv::Mat stored = wavy_image({80, 60}, 3, 8);
  ASSERT_TRUE(copy_to(path, storages()[1], *in_memory(stored)));
  for (int value = 1; value <= 8; ++value) {
    SCOPED_TRACE(value);
    const auto turn = static_cast<ImageTurn>(value);
    const cv::Mat whole = read_picture(path, {.turn = turn}).pixels;
    EXPECT_EQ(whole.cols, swaps_axes(turn) ? 60 : 80);
    const Window window{7, 11, 30, 40};
    EXPECT_TRUE(same(read_picture(path, {.window = window, .turn = turn}).pixels,
                     whole(cv::Rect(7, 11, 30, 40))));
  }
  // TIFF 6.0: of value 6 the first row is the right side, so the first stored pixel comes to the
  // top right.
  const cv::Mat clockwise = read_picture(path, {.turn = ImageTurn::kClockwise}).pixels;
  EXPECT_EQ(clockwise.at<cv::Vec3b>(0, 59), stored.at<cv::Vec3b>(0, 0));
  // 8: the first row is the left side, the first column the bottom.
  const cv::Mat counter = read_picture(path, {.turn = ImageTurn::kCounterClockwise}).pixels;
  EXPECT_EQ(counter.at<cv::Vec3b>(79, 0), stored.at<cv::Vec3b>(0, 0));
  const cv::Mat half = read_picture(path, {.turn = ImageTurn::kHalf}).pixels;
  EXPECT_EQ(half.at<cv::Vec3b>(59, 79), stored.at<cv::Vec3b>(0, 0));
}

/// A TIFF of 2 x 3 grey pixels whose tag Orientation is 6, written byte by byte.
std::string tiff_with_orientation(bool is_big_endian, bool is_big) {
  std::string bytes = is_big_endian ? "MM" : "II";
  const auto add = [&](std::uint64_t value, int n) {
    for (int i = 0; i < n; ++i) {
      const int shift = 8 * (is_big_endian ? n - 1 - i : i);
      bytes += static_cast<char>(value >> shift & 0xFFU);
    }
  };
  const int wide = is_big ? 8 : 4;
  add(is_big ? 43 : 42, 2);
  if (is_big) {
    add(8, 2);
    add(0, 2);
  }
  const std::uint64_t header = is_big ? 16 : 8;
  add(header + 8, wide);  // the directory stands behind the pixels
  bytes += std::string("abcdef\0\0", 8);
  const std::vector<std::array<std::uint64_t, 2>> tags{{256, 2}, {257, 3},      {258, 8}, {259, 1},
                                                       {262, 1}, {273, header}, {274, 6}, {277, 1},
                                                       {278, 3}, {279, 6}};
  add(tags.size(), is_big ? 8 : 2);
  for (const auto& [tag, value] : tags) {
    const bool is_offset = tag == 273;
    add(tag, 2);
    add(is_offset ? 4 : 3, 2);  // LONG or SHORT
    add(1, wide);
    if (is_offset) {
      add(value, 4);
      if (is_big) add(0, 4);
    } else {
      add(value, 2);
      add(0, wide - 2);
    }
  }
  add(0, wide);
  return bytes;
}

TEST(ImageFacts, TurnIsThatOfTheTiffTagInAllFormsOfTheFile) {
  const TempFolder folder;
  const std::string path = folder.file("image.tif");
  for (const bool is_big_endian : {false, true}) {
    for (const bool is_big : {false, true}) {
      std::ofstream(path, std::ios::binary) << tiff_with_orientation(is_big_endian, is_big);
      const ImageFacts facts = image_facts(path);
      EXPECT_EQ(facts.turn, ImageTurn::kClockwise) << is_big_endian << is_big;
      EXPECT_EQ(facts.width_px, 2);
    }
  }
}

TEST(ImageFacts, InkIsRefusedByName) {
  const TempFolder folder;
  const std::string path = folder.file("image.tif");
  ASSERT_TRUE(copy_to(path, {"ink", "GTiff", {"PHOTOMETRIC=CMYK"}, {}, {}},
                      *in_memory(wavy_image({60, 50}, 4, 8))));
  try {
    (void)image_facts(path);
    FAIL() << "read";
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), HasSubstr("CMYK"));
  }
}

TEST(SlowReading, IsSaidOfLargeFilesThatAreDecodedInGreatParts) {
  const TempFolder folder;
  const Window window{3000, 3000, 500, 500};
  const auto made = [&](const char* name, std::vector<const char*> options) {
    options.push_back("SPARSE_OK=YES");
    CPLStringList list;
    for (const char* option : options) list.AddString(option);
    GDALAllRegister();
    const std::string path = folder.file(name);
    const GDALDatasetUniquePtr made_file(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        path.c_str(), 8000, 6000, 1, GDT_Byte, list.List()));
    return path;
  };
  EXPECT_FALSE(slow_reading(made("tiles.tif", {"TILED=YES"}), window));
  EXPECT_FALSE(slow_reading(made("strips.tif", {"BLOCKYSIZE=16"}), window));
  const auto slow =
      slow_reading(made("one_strip.tif", {"BLOCKYSIZE=6000", "COMPRESS=DEFLATE"}), window);
  ASSERT_TRUE(slow);
  EXPECT_THAT(*slow, HasSubstr("TILED=YES"));
}

}  // namespace
}  // namespace ridgeline::io
