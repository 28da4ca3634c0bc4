// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/image.h"

#include "io/error.h"
#include "io/gdal/ogr_support.h"
#include "io/kinds/recognise.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

namespace ridgeline::io {
namespace {

/// Sets options of GDAL for this thread while it lives.
class GdalOptions {
 public:
  GdalOptions() {
    for (const auto& [name, value] : kOptions) CPLSetThreadLocalConfigOption(name, value);
  }
  ~GdalOptions() {
    for (const auto& [name, value] : kOptions) CPLSetThreadLocalConfigOption(name, nullptr);
  }
  GdalOptions(const GdalOptions&) = delete;
  GdalOptions& operator=(const GdalOptions&) = delete;

 private:
  static constexpr std::array<std::pair<const char*, const char*>, 3> kOptions{{
      // a JPEG that ends early is grey from there on; libjpeg calls that a warning
      {"GDAL_ERROR_ON_LIBJPEG_WARNING", "TRUE"},
      // Files beside an image, such as .aux.xml, were not given by the user, so none is read and none is left behind.
      {"GDAL_PAM_ENABLED", "NO"},
      {"GDAL_DISABLE_READDIR_ON_OPEN", "EMPTY_DIR"},
  }};
};

/// Shortens a message, as GDAL repeats itself for every block of a damaged file.
std::string shortened(std::string text) {
  constexpr std::size_t kLongest = 200;
  if (text.size() <= kLongest) return text;
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // UTF-8
  return text.substr(0, end) + "...";
}

GDALDatasetUniquePtr open(const std::string& path, const QuietGdal& quiet) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw MissingFileError(path, "does not exist");
  if (std::filesystem::is_directory(status)) {
    refuse_other_kind(path, Expected::kImage);
    throw IoError(path, "is a folder, not an image");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw IoError(path, "is a device, pipe or socket; an image must be a file");
  }
  register_gdal_drivers();
  // Only these drivers are used, as others of GDAL follow references to more files and to addresses.
  const char* const drivers[] = {"GTiff", "PNG", "JPEG", nullptr};
  GDALDatasetUniquePtr dataset(
      GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
  if (!dataset) {
    refuse_other_kind(path, Expected::kImage);
    throw IoError(path, "is no readable TIFF, PNG or JPEG image: " +
                            shortened(quiet.complaints("its content is none of these")));
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

void check_image_size(const std::string& path, const ImageFacts& facts, double max_mpx) {
  constexpr double kMega = 1e6;
  const double mpx = double(facts.width_px) * facts.height_px / kMega;
  const auto refuse = [&](const std::string& rule) {
    throw IoError(
        path, fmt::format(
                  "{} x {} pixels are {:.4g} million; {}. If the image is meant, allow its size by "
                  "--max-image-mpx {:.0f}",
                  facts.width_px, facts.height_px, mpx, rule, std::ceil(mpx)));
  };
  if (max_mpx > 0.0) {
    if (mpx > max_mpx) refuse(fmt::format("at most {:g} million are allowed", max_mpx));
    return;
  }
  if (mpx > kDefaultMaxImage_mpx) {
    refuse(fmt::format("at most {:g} million are read unasked", kDefaultMaxImage_mpx));
  }
  const auto bytes = static_cast<double>(std::filesystem::file_size(path));
  if (mpx > kFreeImage_mpx + kMaxPixelsPerByte * bytes / kMega) {
    refuse(fmt::format(
        "a file of {:.0f} bytes is read unasked up to {:.4g} million ({:g} and {:g} per byte)",
        bytes, kFreeImage_mpx + kMaxPixelsPerByte * bytes / kMega, kFreeImage_mpx,
        kMaxPixelsPerByte));
  }
}

ImageFacts image_facts(const std::string& path) {
  const QuietGdal quiet;
  const GdalOptions options;
  const GDALDatasetUniquePtr dataset = open(path, quiet);
  return facts_of(path, *dataset);
}

cv::Mat read_image(const std::string& path, double max_mpx) {
  const QuietGdal quiet;
  const GdalOptions options;
  const GDALDatasetUniquePtr dataset = open(path, quiet);
  const ImageFacts facts = facts_of(path, *dataset);
  check_image_size(path, facts, max_mpx);
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
    throw IoError(path,
                  "cannot be decoded: " + shortened(quiet.complaints("its pixels are damaged")));
  }
  return image;
}

}  // namespace ridgeline::io
