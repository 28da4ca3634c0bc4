// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/scene/scene.h"
#include "reconstruct/surface/rectification.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// The surface seen in both views of a pair: the disparity of each pixel of the rectified left
/// view.
struct Surface {
  Rectification rectification;
  /// CV_32F, of the size of the rectified left view; NaN where the disparity is unknown.
  cv::Mat disparity_px;

  /// Disparity of the nearest pixel; std::nullopt outside the view or if the disparity is not
  /// known.
  [[nodiscard]] std::optional<double> at(const Eigen::Vector2d& x_px) const;
};

/// Returns the surface of a pair of views, given by their numbers, or null.
using SurfaceOf = std::function<const Surface*(std::size_t base, std::size_t search)>;
inline const Surface* no_surface(std::size_t /*base*/, std::size_t /*search*/) { return nullptr; }

/// The object points of the pixels with known disparity, row by row. If the view has more than
/// `most` pixels, only every k-th row and column is used, with the smallest k that leaves at most
/// `most` pixels. Throws std::invalid_argument if `most` is 0.
std::vector<Eigen::Vector3d> points_in_local(
    const Surface& surface, std::size_t most = std::numeric_limits<std::size_t>::max());

/// The surface of a pair by hierarchical semi-global matching (Hirschmueller 2008) in square tiles,
/// with subpixel accuracy and a check from right to left. The disparities searched are those of the
/// height range. std::nullopt for a pair that cannot be rectified. The result is the same for any
/// number of threads, because the grid of tiles is fixed.
std::optional<Surface> dense_surface(const StereoPair& pair, int tile_px = 512);

}  // namespace ridgeline::reconstruct
