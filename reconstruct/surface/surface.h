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

/// The surfaces that both views of a pair show: the disparity of each pixel of the rectified left
/// view.
struct Surface {
  Rectification rectification;
  cv::Mat
      disparity_px;  ///< CV_32F, of the size of the rectified left view; NaN where nothing is known

  /// Disparity of the nearest pixel; nothing outside of the view and if the disparity is not known.
  [[nodiscard]] std::optional<double> at(const Eigen::Vector2d& x_px) const;
};

/// The surface of a pair of views, by their numbers, or null.
using SurfaceOf = std::function<const Surface*(std::size_t base, std::size_t search)>;
inline const Surface* no_surface(std::size_t /*base*/, std::size_t /*search*/) { return nullptr; }

/// The points that the pixels of known disparity show, row by row. If the view has more than `most`
/// pixels, only every k-th row and column is used, with the smallest k that leaves no more. Throws
/// std::invalid_argument if `most` is 0.
std::vector<Eigen::Vector3d> points_in_local(
    const Surface& surface, std::size_t most = std::numeric_limits<std::size_t>::max());

/// The surface of a pair by semi-global matching (Hirschmueller 2008) in square tiles,
/// hierarchically and to a part of a pixel, with the check from right to left. Disparities are
/// those of the range of heights. Nothing for a pair that cannot be rectified. The result is the
/// same for any number of threads, because the grid of tiles is fixed.
std::optional<Surface> dense_surface(const StereoPair& pair, int tile_px = 512);

}  // namespace ridgeline::reconstruct
