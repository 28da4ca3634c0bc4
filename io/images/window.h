// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ridgeline::io {

/// A rectangle of pixels of an image.
struct Window {
  int column = 0, row = 0;    ///< of its top-left pixel
  int width = 0, height = 0;  ///< columns, rows

  bool operator==(const Window&) const = default;
};

}  // namespace ridgeline::io
