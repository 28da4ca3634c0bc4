// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <string>

namespace ridgeline::io {

/// What the header of an image file states.
struct ImageFacts {
  std::string format;  ///< "GTiff" | "PNG" | "JPEG"
  int width_px = 0;
  int height_px = 0;
  int n_bands = 0;
  int bits = 0;  ///< per band, 8 or 16
};

/// The most pixels that one image may have, whatever its user allows; OpenCV takes no more by default.
constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 30;

/// Limits for an image whose size its user has not allowed: at most so many megapixels, and beyond kFreeImage_mpx at
/// most so many pixels per byte of the file. A photograph has one byte for at most six or seven pixels. A few
/// kilobytes that decode to gigabytes are no photograph.
constexpr double kDefaultMaxImage_mpx = 400.0;
constexpr double kFreeImage_mpx = 4.0;
constexpr double kMaxPixelsPerByte = 10.0;

/// Reads the header of a TIFF, GeoTIFF, PNG or JPEG; decodes nothing. Throws IoError for a file
/// that is missing or none of these, for a folder, device or pipe, and for what read_image() does not take: bands
/// that are not 8 or 16 bit unsigned (all of one kind), more than 4 bands, a colour table, more than
/// kMaxImagePixels.
ImageFacts image_facts(const std::string& path);

/// Refuses an image that is too large to be decoded. `max_mpx`: what the user allows, million pixels; 0: what the
/// constants above say. Throws IoError with the size, the limit and the option `--max-image-mpx`.
void check_image_size(const std::string& path, const ImageFacts& facts, double max_mpx);

/// The pixels, CV_8UC(n) or CV_16UC(n), n = 1..4, bands in the order of the file, values as stored. Georeference,
/// overviews, masks and nodata values are not read; files beside the image are neither read nor written. `max_mpx` as
/// for check_image_size().
/// Throws IoError as image_facts() and check_image_size(), for fewer than 2 x 2 pixels, and for pixels that cannot be
/// decoded, also if the end of the file is missing.
cv::Mat read_image(const std::string& path, double max_mpx = 0.0);

}  // namespace ridgeline::io
