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

/// Pixels that one image may have. More than any frame camera has; a header that states more is
/// damaged or hostile.
constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 30;

/// Reads the header of a TIFF, GeoTIFF, PNG or JPEG; decodes nothing. Throws IoError for a file
/// that is missing or none of these, and for what read_image() does not take: bands that are not
/// 8 or 16 bit unsigned (all of one kind), more than 4 bands, a colour table, more than
/// kMaxImagePixels.
ImageFacts image_facts(const std::string& path);

/// The pixels, CV_8UC(n) or CV_16UC(n), n = 1..4, bands in the order of the file, values as stored.
/// Georeference, overviews, masks and nodata values are not read. Throws IoError as image_facts(),
/// for fewer than 2 x 2 pixels and if they cannot be decoded, be it by a missing end of the file.
cv::Mat read_image(const std::string& path);

}  // namespace ridgeline::io
