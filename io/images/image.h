// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/images/image_turn.h"
#include "io/images/window.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace ridgeline::io {

/// What the header of an image file states.
struct ImageFacts {
  std::string format;  ///< "GTiff" | "PNG" | "JPEG" | "JP2OpenJPEG"
  int width_px = 0;    ///< as stored
  int height_px = 0;
  int n_bands = 0;
  int bits = 0;  ///< per band, 8 or 16
  ImageTurn turn =
      ImageTurn::kNone;  ///< that the file states; it is made only if ImageReading asks for it
};

/// The most pixels that are read at once, whatever their user allows; OpenCV takes no more by
/// default.
constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 30;

/// Limits for pixels whose number their user has not allowed: at most so many megapixels, and
/// beyond kFreeImage_mpx at most so many pixels per byte of the file. A photograph has one byte for
/// at most six or seven pixels. A few kilobytes that decode to gigabytes are no photograph.
constexpr double kDefaultMaxImage_mpx = 400.0;
constexpr double kFreeImage_mpx = 4.0;
constexpr double kMaxPixelsPerByte = 10.0;

/// Reads the header of a TIFF, GeoTIFF, PNG, JPEG or JPEG 2000; decodes nothing. Throws IoError for
/// a file that is missing or none of these, for a folder, device or pipe, and for what read_image()
/// does not take: bands that are not 8 or 16 bit unsigned (all of one kind), more than 4 bands, a
/// colour table, CMYK, JPEG of 12 bit in TIFF.
ImageFacts image_facts(const std::string& path);

/// Refuses a window (unset: the whole image) that is too large to be decoded. `max_mpx`: what the
/// user allows, million pixels; 0: what the constants above say. Throws IoError with the size, the
/// limit and the option `--max-image-mpx`.
void check_image_size(const std::string& path,
                      const ImageFacts& facts,
                      double max_mpx,
                      const std::optional<Window>& window = std::nullopt);

/// What to read of an image.
struct ImageReading {
  std::optional<Window> window{};     ///< of the turned image; unset: all of it
  ImageTurn turn = ImageTurn::kNone;  ///< of the pixels after reading
  bool samples = true;                ///< whether Picture::sample is wanted
  double max_mpx = 0.0;               ///< see check_image_size()
};

/// Pixels are CV_8UC(n) or CV_16UC(n), n = 1..4, bands in the order of the file, values as stored.
struct Picture {
  cv::Mat pixels;
  cv::Mat is_valid;  ///< CV_8UC1, 0 where the file states that it has no data; empty if it has data
                     ///< everywhere
  /// Pixels of the whole image, N x 1, whatever the window: all of them, or those of at most 256
  /// blocks of 64 x 64 pixels at fixed places of an image of more pixels than that. Pixels without
  /// data are left out, unless there are no others.
  cv::Mat sample;
};

/// Reads an image or a window of it. Only the blocks that hold what is wanted are decoded, if the
/// format allows it; see slow_reading(). Georeference and overviews are not read; files beside the
/// image are neither read nor written. A pixel has no data if a mask in the file says so, or if all
/// its bands have their nodata values. Throws IoError as image_facts() and check_image_size(), for
/// fewer than 2 x 2 pixels, for a window that is not within the image, and for pixels that cannot
/// be decoded, also if the end of the file is missing.
Picture read_picture(const std::string& path, const ImageReading& reading = {});

/// The pixels of a whole image as stored.
cv::Mat read_image(const std::string& path, double max_mpx = 0.0);

/// The image as stored, reduced by a whole factor: each pixel is the mean of `factor` x `factor`
/// pixels; columns and rows at the far end that fill no pixel are left out. No more than the result
/// and a few blocks are held. Throws as read_image(); any size may be read if the result may.
cv::Mat read_reduced_image(const std::string& path, int factor);

/// Why a window takes long to read, and what would help: the file makes GDAL decode far more pixels
/// than the window has. Nothing for other files. Throws IoError as image_facts().
std::optional<std::string> slow_reading(const std::string& path, const Window& window);

}  // namespace ridgeline::io
