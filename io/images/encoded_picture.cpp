// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/encoded_picture.h"

#include "io/gdal/ogr_support.h"
#include "reconstruct/geometry/check.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <array>
#include <atomic>
#include <memory>
#include <stdexcept>
#include <vector>

namespace ridgeline::io {
namespace {

/// Reads or writes all pixels of a dataset, whose bands are in GDAL's order.
CPLErr copy_pixels(GDALRWFlag direction, GDALDataset& dataset, cv::Mat& picture) {
  const int n_bands = picture.channels();
  std::array<int, 3> blue_green_red{n_bands == 3 ? 3 : 1, 2, 1};
  return dataset.RasterIO(direction, 0, 0, picture.cols, picture.rows, picture.data, picture.cols,
                          picture.rows, GDT_Byte, n_bands, blue_green_red.data(),
                          static_cast<GSpacing>(picture.elemSize()),
                          static_cast<GSpacing>(picture.step[0]), 1, nullptr);
}

/// A copy of the picture in memory; null if that fails.
GDALDatasetUniquePtr in_memory(const cv::Mat& picture) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  if (driver == nullptr) return nullptr;
  GDALDatasetUniquePtr dataset(
      driver->Create("", picture.cols, picture.rows, picture.channels(), GDT_Byte, nullptr));
  if (!dataset) return nullptr;
  cv::Mat pixels = picture;  // RasterIO requires a non-const buffer
  const CPLErr error = copy_pixels(GF_Write, *dataset, pixels);
  return error == CE_None ? std::move(dataset) : nullptr;
}

/// A new file name in GDAL's in-memory file system.
std::string file_in_memory() {
  static std::atomic<int> n_files = 0;
  return fmt::format("/vsimem/ridgeline_picture_{}", n_files++);
}

/// Lets GDAL encode a picture into an in-memory file and returns its bytes.
std::string encoded(const cv::Mat& picture, const char* driver_name, const CPLStringList& options) {
  const QuietGdal quiet;
  register_gdal_drivers();
  const std::string file = file_in_memory();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name);
  const GDALDatasetUniquePtr source = in_memory(picture);
  GDALDatasetUniquePtr copy(driver == nullptr || !source
                                ? nullptr
                                : driver->CreateCopy(file.c_str(), source.get(), FALSE,
                                                     options.List(), nullptr, nullptr));
  const bool is_good = copy != nullptr;
  copy.reset();
  vsi_l_offset size = 0;
  const std::unique_ptr<GByte, decltype(&VSIFree)> bytes(
      VSIGetMemFileBuffer(file.c_str(), &size, TRUE), VSIFree);
  VSIUnlink((file + ".aux.xml").c_str());
  if (!is_good || !bytes) {
    throw std::runtime_error(fmt::format("a picture could not be encoded as {}: {}", driver_name,
                                         quiet.complaints("no reason given")));
  }
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are bytes
  return {reinterpret_cast<const char*>(bytes.get()), static_cast<std::size_t>(size)};
}

void check_type(const char* function, const cv::Mat& picture) {
  check(!picture.empty() && (picture.type() == CV_8UC1 || picture.type() == CV_8UC3), function,
        ": OpenCV type ", picture.type(), ", must be CV_8UC1 or CV_8UC3 and not empty");
}

}  // namespace

std::string png_bytes(const cv::Mat& picture) {
  check_type("png_bytes", picture);
  CPLStringList options;
  // The pictures are for display, so speed matters more than size.
  options.SetNameValue("ZLEVEL", "3");
  return encoded(picture, "PNG", options);
}

std::string jpeg_bytes(const cv::Mat& picture, int quality) {
  check_type("jpeg_bytes", picture);
  check(quality >= 1 && quality <= 100, "jpeg_bytes: quality = ", quality, ", must be in [1, 100]");
  CPLStringList options;
  options.SetNameValue("QUALITY", std::to_string(quality).c_str());
  return encoded(picture, "JPEG", options);
}

cv::Mat decoded_jpeg(const std::string& bytes) {
  const QuietGdal quiet;
  register_gdal_drivers();
  const std::string file = file_in_memory();
  std::vector<GByte> content(bytes.begin(), bytes.end());  // GDAL requires a non-const buffer
  VSIFCloseL(VSIFileFromMemBuffer(file.c_str(), content.data(), content.size(), FALSE));
  constexpr std::array<const char*, 2> kDrivers{"JPEG", nullptr};
  GDALDatasetUniquePtr dataset(
      GDALDataset::Open(file.c_str(), GDAL_OF_RASTER, kDrivers.data(), nullptr, nullptr));
  cv::Mat picture;
  CPLErr error = CE_Failure;
  if (dataset) {
    const int type = dataset->GetRasterCount() == 1 ? CV_8UC1 : CV_8UC3;
    picture.create(dataset->GetRasterYSize(), dataset->GetRasterXSize(), type);
    error = copy_pixels(GF_Read, *dataset, picture);
  }
  dataset.reset();
  VSIUnlink(file.c_str());
  if (error != CE_None) {
    throw std::runtime_error("a JPEG file could not be decoded: " +
                             quiet.complaints("no reason given"));
  }
  return picture;
}

}  // namespace ridgeline::io
