// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/images/window.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>

namespace ridgeline::io {

/// How the stored pixels must be turned to be upright: the values of the Orientation tag of TIFF
/// 6.0 and EXIF.
enum class ImageTurn : std::uint8_t {
  kNone = 1,
  kFlipColumns = 2,
  kHalf = 3,
  kFlipRows = 4,
  kTranspose = 5,
  kClockwise = 6,  ///< the stored image must be turned clockwise by 90 degrees
  kTransverse = 7,
  kCounterClockwise = 8
};

/// Whether rows and columns are swapped.
constexpr bool swaps_axes(ImageTurn turn) { return turn >= ImageTurn::kTranspose; }

/// The window of the stored image that corresponds to a window of the turned image.
/// @param stored_width, stored_height  of the whole stored image
Window stored_window(const Window& window, ImageTurn turn, int stored_width, int stored_height);

cv::Mat turned(const cv::Mat& stored, ImageTurn turn);

}  // namespace ridgeline::io
