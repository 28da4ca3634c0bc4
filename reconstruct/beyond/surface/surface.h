// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/surface/rectification.h"
#include "reconstruct/views/scene.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// How the dense matching goes about it.
struct SurfaceOptions {
  int tile_px = 512;   ///< side of a tile
  int margin_px = 64;  ///< matched around a tile as well: what the paths of SGM need to settle
};

/// The surfaces that both views of a pair show: the disparity of each pixel of the rectified left view.
struct Surface {
  Rectification rectification;
  cv::Mat
      disparity_px;  ///< CV_32F, of the size of the rectified left view; NaN where nothing is known

  /// Nothing outside and where nothing is known; of the nearest pixel.
  [[nodiscard]] std::optional<double> at(const Eigen::Vector2d& x_px) const;
};

/// What each pixel of known disparity shows, row by row. Of a view with more than `most` pixels, those of every k-th row and
/// column, with the smallest k that leaves no more. Throws std::invalid_argument if `most` is 0.
std::vector<Eigen::Vector3d> points_in_local(
    const Surface& surface, std::size_t most = std::numeric_limits<std::size_t>::max());

/// Semi-global matching (Hirschmueller 2008, by OpenCV) of the pair in tiles, to a sixteenth of a pixel, with the check
/// from right to left. Disparities are those of the range of heights. Nothing for a pair that cannot be rectified.
/// The same for any number of threads: the grid of tiles is fixed.
std::optional<Surface> dense_surface(const StereoPair& pair, const SurfaceOptions& options = {});

}  // namespace ridgeline::reconstruct
