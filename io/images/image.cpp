// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/image.h"

#include "io/error.h"
#include "io/images/open_image.h"
#include "io/images/sample_places.h"
#include "io/images/tiff_tag.h"

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace ridgeline::io {
namespace {

constexpr double kMega = 1e6;

Window whole_of(int width_px, int height_px) { return {0, 0, width_px, height_px}; }

double pixels_of(const Window& window) { return double(window.width) * window.height; }

/// The requested window in stored pixels. Throws IoError if it is not within the image.
Window wanted(const std::string& path, const ImageFacts& facts, const ImageReading& reading) {
  const bool swaps = swaps_axes(reading.turn);
  const int width = swaps ? facts.height_px : facts.width_px;
  const int height = swaps ? facts.width_px : facts.height_px;
  const Window window = reading.window.value_or(whole_of(width, height));
  if (window.width < 2 || window.height < 2) {
    throw IoError(
        path, fmt::format("{} x {} pixels; must be at least 2 x 2", window.width, window.height));
  }
  const bool is_within = window.column >= 0 && window.row >= 0 && window.width <= width &&
                         window.height <= height && window.column <= width - window.width &&
                         window.row <= height - window.height;
  if (!is_within) {
    throw IoError(
        path, fmt::format("{} x {} pixels do not contain the window of {} x {} at {}, {}", width,
                          height, window.width, window.height, window.column, window.row));
  }
  return stored_window(window, reading.turn, facts.width_px, facts.height_px);
}

/// Appends the valid pixels of a list; all of them if `valid` is empty.
void append(const cv::Mat& list, const cv::Mat& valid, cv::Mat& pixels) {
  if (valid.empty()) return pixels.push_back(list);
  const cv::Mat is_valid = valid.reshape(0, list.rows);
  for (int i = 0; i < list.rows; ++i) {
    if (is_valid.at<std::uint8_t>(i) != 0) pixels.push_back(list.row(i));
  }
}

/// An open image whose windows can be read. Windows are in stored pixels.
class OpenImage {
 public:
  OpenImage(const std::string& path, const ImageSession& session)
      : path_(path), session_(session), dataset_(session.open(path)) {
    facts_ = facts_of(path, *dataset_);
    for (int number = 1; number <= dataset_->GetRasterCount(); ++number) {
      if (!facts_.alpha || number != facts_.alpha->number) bands_.push_back(number);
    }
  }

  [[nodiscard]] const ImageFacts& facts() const { return facts_; }

  /// The pixels of a window whose sides are multiples of `factor`, each the mean of `factor` x
  /// `factor`.
  [[nodiscard]] cv::Mat pixels(const Window& window, int factor = 1) const {
    const int depth = facts_.bits == 8 ? CV_8U : CV_16U;
    cv::Mat image(window.height / factor, window.width / factor,
                  CV_MAKETYPE(depth, facts_.n_bands));
    const auto band_step = static_cast<GSpacing>(image.elemSize1());
    std::vector<int> bands = bands_;  // GDAL requires a non-const list
    GDALRasterIOExtraArg means;
    INIT_RASTERIO_EXTRA_ARG(means);
    means.eResampleAlg = GRIORA_Average;
    const CPLErr error = dataset_->RasterIO(
        GF_Read, window.column, window.row, window.width, window.height, image.data, image.cols,
        image.rows, facts_.bits == 8 ? GDT_Byte : GDT_UInt16, facts_.n_bands, bands.data(),
        band_step * facts_.n_bands, static_cast<GSpacing>(image.step[0]), band_step, &means);
    if (error != CE_None) session_.fail_to_decode(path_);
    return image;
  }

  /// Mask of the pixels with data; empty if all of them have data.
  [[nodiscard]] cv::Mat is_valid(const Window& window, const cv::Mat& pixels) const {
    cv::Mat valid = is_stated_valid(window, pixels);
    if (facts_.alpha) {
      GDALRasterBand& alpha = *dataset_->GetRasterBand(facts_.alpha->number);
      const cv::Mat is_opaque = values(window, alpha, GDT_UInt16) == facts_.alpha->opaque;
      valid = valid.empty() ? is_opaque : valid & is_opaque;
    }
    return cv::countNonZero(valid) == static_cast<int>(valid.total()) ? cv::Mat() : valid;
  }

  /// Returns Picture::sample. `whole` contains the pixels of the whole image if they have been
  /// read.
  [[nodiscard]] cv::Mat sample(const cv::Mat& whole) const {
    cv::Mat valid_ones;
    cv::Mat all;
    for (const Window& place : sample_places({facts_.width_px, facts_.height_px})) {
      const cv::Rect area(place.column, place.row, place.width, place.height);
      const cv::Mat block = whole.empty() ? pixels(place) : whole(area).clone();
      const cv::Mat list = block.reshape(0, static_cast<int>(block.total()));
      const cv::Mat valid = is_valid(place, block);
      append(list, valid, valid_ones);
      if (valid_ones.empty()) all.push_back(list);
    }
    return valid_ones.empty() ? all : valid_ones;
  }

  /// How many pixels GDAL decodes for a window.
  [[nodiscard]] double decoded_pixels(const Window& window) const {
    int width = 0;
    int height = 0;
    dataset_->GetRasterBand(1)->GetBlockSize(&width, &height);
    const int end_row = window.row + window.height;
    if (const std::optional<int> rows = rows_in_sequence()) {
      const int first_row = window.row / *rows * *rows;
      return double(facts_.width_px) * (end_row - first_row);
    }
    const auto covered = [](int first, int end, int block, int limit) {
      return std::min((end + block - 1) / block * block, limit) - first / block * block;
    };
    return double(covered(window.column, window.column + window.width, width, facts_.width_px)) *
           covered(window.row, end_row, height, facts_.height_px);
  }

 private:
  /// The values of a band, as GDT_Byte or GDT_UInt16.
  [[nodiscard]] cv::Mat values(const Window& window, GDALRasterBand& band, GDALDataType as) const {
    cv::Mat pixels(window.height, window.width, as == GDT_Byte ? CV_8UC1 : CV_16UC1);
    const CPLErr error = band.RasterIO(GF_Read, window.column, window.row, window.width,
                                       window.height, pixels.data, window.width, window.height, as,
                                       0, static_cast<GSpacing>(pixels.step[0]), nullptr);
    if (error != CE_None) session_.fail_to_decode(path_);
    return pixels;
  }

  /// The mask by the file's own mask or its nodata values; empty without either.
  [[nodiscard]] cv::Mat is_stated_valid(const Window& window, const cv::Mat& pixels) const {
    cv::Mat valid;
    for (int i = 0; i < facts_.n_bands; ++i) {
      GDALRasterBand& band = *dataset_->GetRasterBand(bands_[static_cast<std::size_t>(i)]);
      const int flags = band.GetMaskFlags();
      if ((flags & GMF_PER_DATASET) != 0 && (flags & GMF_ALPHA) == 0)
        return values(window, *band.GetMaskBand(), GDT_Byte) != 0;
      if ((flags & GMF_NODATA) == 0) return {};
      cv::Mat of_band;
      cv::extractChannel(pixels, of_band, i);
      of_band = of_band != band.GetNoDataValue();
      valid = valid.empty() ? of_band : valid | of_band;
    }
    return valid;
  }

  /// The number of rows that can only be decoded in sequence: all rows of a PNG or JPEG, or those
  /// of a compressed strip, which GDAL may report as blocks of one row.
  [[nodiscard]] std::optional<int> rows_in_sequence() const {
    constexpr std::uint64_t kUncompressed = 1;
    if (facts_.format == "PNG" || facts_.format == "JPEG") return facts_.height_px;
    if (facts_.format != "GTiff" || tiff_tag(path_, kTiffCompression) == kUncompressed)
      return std::nullopt;
    const std::optional<std::uint64_t> rows = tiff_tag(path_, kTiffRowsPerStrip);
    if (!rows || *rows == 0) return std::nullopt;
    return static_cast<int>(std::min(*rows, static_cast<std::uint64_t>(facts_.height_px)));
  }

  const std::string& path_;
  const ImageSession& session_;
  GDALDatasetUniquePtr dataset_;
  ImageFacts facts_;
  std::vector<int> bands_;  ///< numbers of the bands of colours
};

}  // namespace

void check_image_size(const std::string& path,
                      const ImageFacts& facts,
                      double max_mpx,
                      const std::optional<Window>& window) {
  const Window read = window.value_or(whole_of(facts.width_px, facts.height_px));
  const double mpx = pixels_of(read) / kMega;
  if (pixels_of(read) > double(kMaxImagePixels)) {
    throw IoError(path, fmt::format("is {} x {} pixels; at most {} pixels can be read at once",
                                    read.width, read.height, kMaxImagePixels));
  }
  const auto refuse = [&](const std::string& rule) {
    throw IoError(
        path,
        fmt::format("{} x {} pixels are {:.4g} million; {}. If that is intended, allow it with "
                    "`max_image_mpx` {:.0f}",
                    read.width, read.height, mpx, rule, std::ceil(mpx)));
  };
  if (max_mpx > 0.0) {
    if (mpx > max_mpx) refuse(fmt::format("the limit is {:g} million", max_mpx));
    return;
  }
  if (mpx > kDefaultMaxImage_mpx) {
    refuse(fmt::format("the default limit is {:g} million", kDefaultMaxImage_mpx));
  }
  const auto bytes = static_cast<double>(std::filesystem::file_size(path));
  if (mpx > kFreeImage_mpx + kMaxPixelsPerByte * bytes / kMega) {
    refuse(
        fmt::format("the default limit for a file of {:.0f} bytes is {:.4g} million ({:g} million "
                    "and {:g} pixels per byte)",
                    bytes, kFreeImage_mpx + kMaxPixelsPerByte * bytes / kMega, kFreeImage_mpx,
                    kMaxPixelsPerByte));
  }
}

ImageFacts image_facts(const std::string& path) {
  const ImageSession session;
  return facts_of(path, *session.open(path));
}

Picture read_picture(const std::string& path, const ImageReading& reading) {
  const ImageSession session;
  const OpenImage image(path, session);
  check_image_size(path, image.facts(), reading.max_mpx, reading.window);
  const Window window = wanted(path, image.facts(), reading);
  const cv::Mat pixels = image.pixels(window);
  const cv::Mat valid = image.is_valid(window, pixels);
  const cv::Mat sample =
      reading.samples ? image.sample(reading.window ? cv::Mat() : pixels) : cv::Mat();
  return {turned(pixels, reading.turn), valid.empty() ? valid : turned(valid, reading.turn),
          sample};
}

cv::Mat read_image(const std::string& path, double max_mpx) {
  const ImageSession session;
  const OpenImage image(path, session);
  check_image_size(path, image.facts(), max_mpx);
  return image.pixels(wanted(path, image.facts(), {}));
}

cv::Mat read_reduced_image(const std::string& path, int factor) {
  const ImageSession session;
  const OpenImage image(path, session);
  const ImageFacts& facts = image.facts();
  const Window used{0, 0, facts.width_px / factor * factor, facts.height_px / factor * factor};
  check_image_size(path, facts, 0.0, Window{0, 0, used.width / factor, used.height / factor});
  (void)wanted(path, facts, {.window = used});
  return image.pixels(used, factor);
}

std::optional<std::string> slow_reading(const std::string& path, const Window& window) {
  constexpr double kMuch_mpx = 20.0;  // about a tenth of a second
  constexpr double kTimesTheWindow = 8.0;
  const ImageSession session;
  const OpenImage image(path, session);
  const double decoded = image.decoded_pixels(window);
  if (decoded < kMuch_mpx * kMega || decoded < kTimesTheWindow * pixels_of(window))
    return std::nullopt;
  return fmt::format(
      "{}: {:.0f} million pixels are decoded for a window of {:.2g} million; a tiled file is "
      "faster (gdal_translate -co TILED=YES -co COMPRESS=DEFLATE {} OUT.tif)",
      path, decoded / kMega, pixels_of(window) / kMega, path);
}

}  // namespace ridgeline::io
