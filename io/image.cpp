// SPDX-License-Identifier: BSD-3-Clause
#include "io/image.h"

#include "io/error.h"
#include "io/lines/ogr_support.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <filesystem>
#include <memory>

namespace ridgeline::io {
namespace {

/// A JPEG that ends early is grey from there on; libjpeg calls that a warning.
class StrictJpeg {
 public:
  StrictJpeg() { CPLSetThreadLocalConfigOption(kOption, "TRUE"); }
  ~StrictJpeg() { CPLSetThreadLocalConfigOption(kOption, nullptr); }
  StrictJpeg(const StrictJpeg&) = delete;
  StrictJpeg& operator=(const StrictJpeg&) = delete;

 private:
  static constexpr const char* kOption = "GDAL_ERROR_ON_LIBJPEG_WARNING";
};

GDALDatasetUniquePtr open(const std::string& path, const QuietGdal& quiet) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw IoError(path, "does not exist");
  if (std::filesystem::is_directory(status)) throw IoError(path, "is a folder, not an image");
  GDALAllRegister();
  // Only these: other drivers of GDAL follow references to more files and to addresses.
  const char* const drivers[] = {"GTiff", "PNG", "JPEG", nullptr};
  GDALDatasetUniquePtr dataset(
      GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
  if (!dataset) {
    throw IoError(path, "is no readable TIFF, PNG or JPEG image: " +
                            quiet.complaints("its content is none of these"));
  }
  return dataset;
}

int bits_of(const std::string& path, GDALRasterBand& band, int number) {
  switch (band.GetRasterDataType()) {
    case GDT_Byte:
      return 8;
    case GDT_UInt16:
      return 16;
    default:
      throw IoError(path, fmt::format("band {} is {}; must be 8 or 16 bit unsigned", number,
                                      GDALGetDataTypeName(band.GetRasterDataType())));
  }
}

ImageFacts facts_of(const std::string& path, GDALDataset& dataset) {
  ImageFacts facts{.format = dataset.GetDriver()->GetDescription(),
                   .width_px = dataset.GetRasterXSize(),
                   .height_px = dataset.GetRasterYSize(),
                   .n_bands = dataset.GetRasterCount()};
  if (facts.n_bands < 1 || facts.n_bands > 4) {
    throw IoError(path, fmt::format("has {} bands; must be 1 to 4", facts.n_bands));
  }
  if (std::int64_t{facts.width_px} * facts.height_px > kMaxImagePixels) {
    throw IoError(path, fmt::format("is {} x {} pixels; at most {} pixels can be read",
                                    facts.width_px, facts.height_px, kMaxImagePixels));
  }
  for (int number = 1; number <= facts.n_bands; ++number) {
    GDALRasterBand& band = *dataset.GetRasterBand(number);
    const int bits = bits_of(path, band, number);
    if (number > 1 && bits != facts.bits) {
      throw IoError(path, fmt::format("band {} has {} bits, band 1 has {}; all must have the same",
                                      number, bits, facts.bits));
    }
    facts.bits = bits;
    if (band.GetColorTable() != nullptr) {
      throw IoError(path, "has a colour table; expand it to bands (gdal_translate -expand rgb)");
    }
  }
  return facts;
}

}  // namespace

ImageFacts image_facts(const std::string& path) {
  const QuietGdal quiet;
  const GDALDatasetUniquePtr dataset = open(path, quiet);
  return facts_of(path, *dataset);
}

cv::Mat read_image(const std::string& path) {
  const QuietGdal quiet;
  const StrictJpeg strict;
  const GDALDatasetUniquePtr dataset = open(path, quiet);
  const ImageFacts facts = facts_of(path, *dataset);
  if (facts.width_px < 2 || facts.height_px < 2) {
    throw IoError(path, fmt::format("{} x {} pixels; must be at least 2 x 2", facts.width_px,
                                    facts.height_px));
  }
  const int depth = facts.bits == 8 ? CV_8U : CV_16U;
  cv::Mat image(facts.height_px, facts.width_px, CV_MAKETYPE(depth, facts.n_bands));
  const auto band_step = static_cast<GSpacing>(image.elemSize1());
  const CPLErr error = dataset->RasterIO(
      GF_Read, 0, 0, facts.width_px, facts.height_px, image.data, facts.width_px, facts.height_px,
      facts.bits == 8 ? GDT_Byte : GDT_UInt16, facts.n_bands, nullptr, band_step * facts.n_bands,
      static_cast<GSpacing>(image.step[0]), band_step, nullptr);
  if (error != CE_None) {
    throw IoError(path, "cannot be decoded: " + quiet.complaints("its pixels are damaged"));
  }
  return image;
}

}  // namespace ridgeline::io
