// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/alpha_band.h"

#include "tests/support/temp_folder.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::io {
namespace {

constexpr int kWidth_px = 80;
constexpr int kHeight_px = 60;
/// Columns on the left that are transparent.
constexpr int kTransparent_px = 20;

/// Bands of different slopes; 0 in the transparent part.
template <typename T>
std::vector<cv::Mat> colours(int n_bands) {
  std::vector<cv::Mat> bands;
  for (int band = 0; band < n_bands; ++band) {
    cv::Mat_<T> values(kHeight_px, kWidth_px, T{0});
    for (int y = 0; y < kHeight_px; ++y)
      for (int x = kTransparent_px; x < kWidth_px; ++x)
        values(y, x) = static_cast<T>(10 + x + (band + 1) * y % 97);
    bands.push_back(values);
  }
  return bands;
}

template <typename T>
cv::Mat alpha(T opaque) {
  cv::Mat_<T> values(kHeight_px, kWidth_px, opaque);
  values.colRange(0, kTransparent_px) = T{0};
  return values;
}

/// Writes bands of which the last one is declared as alpha.
void write_with_alpha(const std::string& path,
                      const char* driver,
                      const std::vector<cv::Mat>& bands) {
  GDALAllRegister();
  GDALDriverManager& drivers = *GetGDALDriverManager();
  const int n_bands = static_cast<int>(bands.size());
  const GDALDataType type = bands[0].depth() == CV_8U ? GDT_Byte : GDT_UInt16;
  const GDALDatasetUniquePtr memory(
      drivers.GetDriverByName("MEM")->Create("", kWidth_px, kHeight_px, n_bands, type, nullptr));
  for (int i = 0; i < n_bands; ++i) {
    GDALRasterBand& band = *memory->GetRasterBand(i + 1);
    cv::Mat pixels = bands[static_cast<std::size_t>(i)];
    ASSERT_EQ(band.RasterIO(GF_Write, 0, 0, kWidth_px, kHeight_px, pixels.data, kWidth_px,
                            kHeight_px, type, 0, static_cast<GSpacing>(pixels.step[0]), nullptr),
              CE_None);
  }
  memory->GetRasterBand(n_bands)->SetColorInterpretation(GCI_AlphaBand);
  const GDALDatasetUniquePtr copy(drivers.GetDriverByName(driver)->CreateCopy(
      path.c_str(), memory.get(), 0, nullptr, nullptr, nullptr));
  ASSERT_TRUE(copy);
}

std::vector<cv::Mat> with(std::vector<cv::Mat> bands, const cv::Mat& last) {
  bands.push_back(last);
  return bands;
}

/// The picture has `n_bands` colours, and no data in the transparent columns.
void expect_masked(const std::string& path, int n_bands) {
  EXPECT_EQ(image_facts(path).n_bands, n_bands);
  EXPECT_TRUE(image_facts(path).alpha.has_value());
  const Picture picture = read_picture(path);
  EXPECT_EQ(picture.pixels.channels(), n_bands);
  ASSERT_FALSE(picture.is_valid.empty());
  EXPECT_EQ(cv::countNonZero(picture.is_valid), (kWidth_px - kTransparent_px) * kHeight_px);
  EXPECT_EQ(cv::countNonZero(picture.is_valid.colRange(0, kTransparent_px)), 0);
  EXPECT_EQ(picture.sample.rows, (kWidth_px - kTransparent_px) * kHeight_px);
  EXPECT_EQ(picture.sample.channels(), n_bands);
  const Window opaque{kTransparent_px, 0, 30, 30};
  EXPECT_TRUE(read_picture(path, {.window = opaque}).is_valid.empty());
}

TEST(AlphaBand, IsAMaskAndNoColourInEveryFormat) {
  const TempFolder folder;
  const std::string path = folder.file("image");
  constexpr std::uint8_t kByte = 255;
  constexpr std::uint16_t kWord = 65535;
  for (const char* driver : {"GTiff", "PNG"}) {
    for (const int n_bands : {1, 3}) {
      SCOPED_TRACE(std::string(driver) + std::to_string(n_bands));
      write_with_alpha(path, driver, with(colours<std::uint8_t>(n_bands), alpha(kByte)));
      expect_masked(path, n_bands);
      write_with_alpha(path, driver, with(colours<std::uint16_t>(n_bands), alpha(kWord)));
      expect_masked(path, n_bands);
    }
  }
  constexpr std::uint16_t kTwelveBits = 4095;
  write_with_alpha(path, "GTiff", with(colours<std::uint16_t>(3), alpha(kTwelveBits)));
  expect_masked(path, 3);
  write_with_alpha(path, "GTiff", with(colours<std::uint8_t>(4), alpha(kByte)));
  expect_masked(path, 4);
}

TEST(AlphaBand, BlendedBorderHasNoData) {
  const TempFolder folder;
  const std::string path = folder.file("image.tif");
  cv::Mat blended = alpha<std::uint8_t>(255);
  blended.col(kTransparent_px - 1).setTo(120);
  write_with_alpha(path, "GTiff", with(colours<std::uint8_t>(3), blended));
  expect_masked(path, 3);
}

TEST(AlphaBand, WithOtherValuesIsASpectralBand) {
  const TempFolder folder;
  const std::string path = folder.file("infrared.tif");
  write_with_alpha(path, "GTiff", colours<std::uint8_t>(4));
  EXPECT_EQ(image_facts(path).n_bands, 4);
  EXPECT_FALSE(image_facts(path).alpha.has_value());
  const Picture picture = read_picture(path);
  EXPECT_EQ(picture.pixels.channels(), 4);
  EXPECT_TRUE(picture.is_valid.empty());
}

TEST(AlphaBand, OfOneValueMasksNothing) {
  const TempFolder folder;
  const std::string path = folder.file("image.tif");
  for (const int value : {0, 255}) {
    const cv::Mat same(kHeight_px, kWidth_px, CV_8UC1, cv::Scalar(value));
    write_with_alpha(path, "GTiff", with(colours<std::uint8_t>(3), same));
    const Picture picture = read_picture(path);
    EXPECT_EQ(picture.pixels.channels(), 3);
    EXPECT_TRUE(picture.is_valid.empty()) << value;
  }
}

}  // namespace
}  // namespace ridgeline::io
