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

namespace ridgeline::io {
namespace {

/// A copy of the picture in memory, bands in GDAL's order; null if that fails.
GDALDatasetUniquePtr in_memory(const cv::Mat& picture) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  if (driver == nullptr) return nullptr;
  const int n_bands = picture.channels();
  GDALDatasetUniquePtr dataset(
      driver->Create("", picture.cols, picture.rows, n_bands, GDT_Byte, nullptr));
  if (!dataset) return nullptr;
  cv::Mat pixels = picture;  // RasterIO takes no constant buffer
  std::array<int, 3> blue_green_red{n_bands == 3 ? 3 : 1, 2, 1};
  const CPLErr error = dataset->RasterIO(
      GF_Write, 0, 0, picture.cols, picture.rows, pixels.data, picture.cols, picture.rows, GDT_Byte,
      n_bands, blue_green_red.data(), static_cast<GSpacing>(picture.elemSize()),
      static_cast<GSpacing>(picture.step[0]), 1, nullptr);
  return error == CE_None ? std::move(dataset) : nullptr;
}

/// The bytes of a picture that GDAL encodes into a file of its file system in memory.
std::string encoded(const cv::Mat& picture, const char* driver_name, const CPLStringList& options) {
  static std::atomic<int> n_files = 0;
  const QuietGdal quiet;
  register_gdal_drivers();
  const std::string file = fmt::format("/vsimem/ridgeline_picture_{}", n_files++);
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
  // The pictures are for people, so time counts more than bytes.
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

}  // namespace ridgeline::io
