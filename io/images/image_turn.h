// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/images/window.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>

namespace ridgeline::io {

/// How the stored pixels have to be turned to stand upright: the values of the tag Orientation of
/// TIFF 6.0 and EXIF.
enum class ImageTurn : std::uint8_t {
  kNone = 1,
  kFlipColumns = 2,
  kHalf = 3,
  kFlipRows = 4,
  kTranspose = 5,
  kClockwise = 6,  ///< the stored image is turned clockwise by 90 degrees
  kTransverse = 7,
  kCounterClockwise = 8
};

/// Whether rows and columns change places.
constexpr bool swaps_axes(ImageTurn turn) { return turn >= ImageTurn::kTranspose; }

/// The stored pixels that a window of the turned image shows.
/// @param stored_width, stored_height  of the whole stored image
Window stored_window(const Window& window, ImageTurn turn, int stored_width, int stored_height);

/// Turns pixels.
cv::Mat turned(const cv::Mat& stored, ImageTurn turn);

}  // namespace ridgeline::io
