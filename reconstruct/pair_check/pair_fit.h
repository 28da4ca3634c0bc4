// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/pair_check/point_matches.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// What the cameras of a pair say, in local coordinates.
struct PairGeometry {
  std::array<ProjectionMatrix, 2> image_from_local;
  std::array<double, 2> heights_m{};  ///< lowest and highest of the objects
  /// Takes the distortion of the lens away, nothing outside of its field; empty for a camera without.
  std::array<std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector2d&)>, 2>
      ideal_from_image;
};

/// How well points of a pair fit its cameras. All distances are the mean of those in both images.
struct PairFit {
  std::size_t n_points = 0;  ///< that both cameras can have seen
  /// Median distance of a point from the epipolar line of its mate, px; NaN without points.
  double median_y_parallax_px = 0.0;
  /// Share of the points within the limit of the part of that line that the heights leave, in [0, 1].
  double share_that_fits = 0.0;
};

/// `limit_px`: of share_that_fits.
PairFit fit_of_pair(std::span<const PointMatch> points,
                    const PairGeometry& geometry,
                    double limit_px);

/// How the files of a pair may have been made from what its cameras saw.
struct PairReading {
  bool swapped = false;
  std::array<int, 2> turned_deg{0, 0};    ///< clockwise: 0, 90, 180, 270
  std::array<double, 2> scale{1.0, 1.0};  ///< 0.5: the file has half of the camera's pixels a side
};

/// A point of the files where the cameras would have it. `sizes_px`: width and height of the files.
PointMatch as_seen(const PointMatch& file_points,
                   const std::array<Eigen::Vector2i, 2>& sizes_px,
                   const PairReading& reading);

/// The readings other than the plain one under which at least half of the points fit, and of these the best with
/// those that are nearly as good: where the epipolar lines are parallel, swapped images and such that are both
/// turned by 180 degrees look the same. Simple ones first. Tried: swapped; one or both turned by one angle; one or
/// both of half or double size.
std::vector<PairReading> fitting_readings(std::span<const PointMatch> points,
                                          const std::array<Eigen::Vector2i, 2>& sizes_px,
                                          const PairGeometry& geometry,
                                          double limit_px);

}  // namespace ridgeline::reconstruct
