// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/images/image_turn.h"
#include "io/images/window.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace ridgeline::io {

/// The band of an image that states which pixels are transparent.
struct AlphaBand {
  int number = 0;            ///< from 1
  std::uint16_t opaque = 0;  ///< its value where the image has data
};

/// What the header of an image file states.
struct ImageFacts {
  std::string format;  ///< "GTiff" | "PNG" | "JPEG" | "JP2OpenJPEG"
  int width_px = 0;    ///< as stored
  int height_px = 0;
  int n_bands = 0;  ///< without `alpha`
  int bits = 0;     ///< per band, 8 or 16
  std::optional<AlphaBand> alpha{};
  ImageTurn turn =
      ImageTurn::kNone;  ///< stated by the file; applied only if ImageReading requests it
};

/// Maximum number of pixels that are read at once, whatever the user allows; OpenCV's default
/// limit.
constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 30;

/// Limits if the user does not set one: at most kDefaultMaxImage_mpx megapixels, and above
/// kFreeImage_mpx at most kMaxPixelsPerByte pixels per byte of the file. A photograph has at most
/// six or seven pixels per byte. A few kilobytes that decode to gigabytes are not a photograph.
constexpr double kDefaultMaxImage_mpx = 400.0;
constexpr double kFreeImage_mpx = 4.0;
constexpr double kMaxPixelsPerByte = 10.0;

/// Reads the header of a TIFF, GeoTIFF, PNG, JPEG or JPEG 2000; decodes nothing but a sample of a
/// band that is declared as alpha. Throws IoError for a missing file, another format, a folder,
/// device or pipe, and for images that read_image() does not support: bands that are not all 8-bit
/// or all 16-bit unsigned, more than 4 bands besides alpha, a colour table, CMYK, 12-bit JPEG in
/// TIFF.
ImageFacts image_facts(const std::string& path);

/// Refuses a window (unset: the whole image) that is too large to be decoded. `max_mpx`: the user's
/// limit in million pixels; 0: the constants above apply. Throws IoError with the size, the limit
/// and the option `--max-image-mpx`.
void check_image_size(const std::string& path,
                      const ImageFacts& facts,
                      double max_mpx,
                      const std::optional<Window>& window = std::nullopt);

/// What to read of an image.
struct ImageReading {
  std::optional<Window> window{};     ///< in the turned image; unset: all of it
  ImageTurn turn = ImageTurn::kNone;  ///< applied to the pixels after reading
  bool samples = true;                ///< whether Picture::sample is wanted
  double max_mpx = 0.0;               ///< see check_image_size()
};

/// Pixels are CV_8UC(n) or CV_16UC(n), n = 1..4, bands in file order without alpha, values as
/// stored.
struct Picture {
  cv::Mat pixels;
  cv::Mat is_valid;  ///< CV_8UC1, 0 where the file states that there is no data; empty if all
                     ///< pixels have data
  /// Pixels of the whole image, N x 1, whatever the window: all of them, or for larger images those
  /// of at most 256 blocks of 64 x 64 pixels at fixed positions. Pixels without data are left out,
  /// unless there are no others.
  cv::Mat sample;
};

/// Reads an image or a window of it. Only the blocks that are needed are decoded, if the format
/// allows it; see slow_reading(). Georeference and overviews are not read; files next to the image
/// are neither read nor written. A pixel has no data if a mask in the file marks it so, if all its
/// bands have their nodata values, or if it is not opaque. Throws IoError under the same conditions
/// as image_facts() and check_image_size(), for fewer than 2 x 2 pixels, for a window that is not
/// within the image, and for pixels that cannot be decoded, including those of a truncated file.
Picture read_picture(const std::string& path, const ImageReading& reading = {});

/// The pixels of a whole image as stored.
cv::Mat read_image(const std::string& path, double max_mpx = 0.0);

/// The image as stored, reduced by an integer factor: each pixel is the mean of `factor` x `factor`
/// pixels; columns and rows at the far end that do not fill a pixel are left out. Only the result
/// and a few blocks are in memory. Throws IoError under the same conditions as read_image(), but
/// the size limits apply to the result only.
cv::Mat read_reduced_image(const std::string& path, int factor);

/// Explains why a window is slow to read, and what would help: because of the file's layout, GDAL
/// decodes far more pixels than the window contains. std::nullopt if it is not slow. Throws IoError
/// under the same conditions as image_facts().
std::optional<std::string> slow_reading(const std::string& path, const Window& window);

}  // namespace ridgeline::io
