// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/open_image.h"

#include "io/error.h"
#include "io/images/alpha_band.h"
#include "io/images/stated_turn.h"
#include "io/kinds/recognise.h"

#include <cpl_conv.h>
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

namespace ridgeline::io {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 3> kOptions{{
    // a truncated JPEG is grey after the break, for which libjpeg only issues a warning
    {"GDAL_ERROR_ON_LIBJPEG_WARNING", "TRUE"},
    // Files next to an image, such as .aux.xml, were not given by the user, so they are neither
    // read nor written.
    {"GDAL_PAM_ENABLED", "NO"},
    {"GDAL_DISABLE_READDIR_ON_OPEN", "EMPTY_DIR"},
}};

/// Shortens a message, because GDAL repeats itself for every block of a damaged file.
std::string shortened(std::string text) {
  constexpr std::size_t kMaxLength = 200;
  if (text.size() <= kMaxLength) return text;
  std::size_t end = kMaxLength;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;  // UTF-8
  return text.substr(0, end) + "...";
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

/// GDAL's information on how pixels are stored; empty if there is none.
std::string_view structure(GDALMajorObject& object, const char* key) {
  const char* const text = object.GetMetadataItem(key, "IMAGE_STRUCTURE");
  return text == nullptr ? std::string_view() : std::string_view(text);
}

void require_known_colours(const std::string& path, GDALDataset& dataset) {
  GDALRasterBand& first = *dataset.GetRasterBand(1);
  if (first.GetColorInterpretation() == GCI_CyanBand ||
      structure(dataset, "SOURCE_COLOR_SPACE") == "CMYK") {
    throw IoError(path,
                  "is a CMYK image; convert it to grey values, RGB or the bands of the camera");
  }
  if (structure(dataset, "COMPRESSION").ends_with("JPEG") && structure(first, "NBITS") == "12") {
    throw IoError(path,
                  "is a TIFF with 12-bit JPEG compression, which is not supported; compress it "
                  "with deflate (gdal_translate -co COMPRESS=DEFLATE -co TILED=YES)");
  }
}

}  // namespace

ImageSession::ImageSession() {
  for (const auto& [name, value] : kOptions) CPLSetThreadLocalConfigOption(name, value);
}

ImageSession::~ImageSession() {
  for (const auto& [name, value] : kOptions) CPLSetThreadLocalConfigOption(name, nullptr);
}

GDALDatasetUniquePtr ImageSession::open(const std::string& path) const {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw MissingFileError(path, "does not exist");
  if (std::filesystem::is_directory(status)) {
    require_kind(path, FileGroup::kImage);
    throw IoError(path, "is a folder, not an image");
  }
  if (!std::filesystem::is_regular_file(status)) {
    throw IoError(path, "is a device, pipe or socket; an image must be a regular file");
  }
  register_gdal_drivers();
  // Only these drivers are used, because other GDAL drivers follow references to further files and
  // to URLs.
  const char* const drivers[] = {"GTiff", "PNG", "JPEG", "JP2OpenJPEG", nullptr};
  GDALDatasetUniquePtr dataset(
      GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers));
  if (!dataset) {
    require_kind(path, FileGroup::kImage);
    throw IoError(path, "is not a readable TIFF, PNG, JPEG or JPEG 2000 image: " +
                            shortened(quiet_.complaints("the content has none of these formats")));
  }
  return dataset;
}

void ImageSession::fail_to_decode(const std::string& path) const {
  throw IoError(path,
                "cannot be decoded: " + shortened(quiet_.complaints("its pixels are damaged")));
}

ImageFacts facts_of(const std::string& path, GDALDataset& dataset) {
  ImageFacts facts{.format = dataset.GetDriver()->GetDescription(),
                   .width_px = dataset.GetRasterXSize(),
                   .height_px = dataset.GetRasterYSize(),
                   .n_bands = dataset.GetRasterCount(),
                   .bits = 0,
                   .alpha = alpha_band(dataset),
                   .turn = stated_turn(path, dataset)};
  const int n_stored = facts.n_bands;
  if (facts.alpha) --facts.n_bands;
  if (facts.n_bands < 1 || facts.n_bands > 4) {
    throw IoError(path, fmt::format("has {} bands; must be 1 to 4", facts.n_bands));
  }
  require_known_colours(path, dataset);
  for (int number = 1; number <= n_stored; ++number) {
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

}  // namespace ridgeline::io
