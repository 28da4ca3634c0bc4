// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/scene/pair_check/point_matches.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The cameras of a pair and the height range, in local coordinates.
struct PairGeometry {
  std::array<ProjectionMatrix, 2> image_from_local;
  std::array<double, 2> heights_m{};  ///< lowest and highest height of objects
  /// Functions that remove the lens distortion; they return std::nullopt outside the field for
  /// which it is known. Empty for a camera without distortion.
  std::array<std::function<std::optional<Eigen::Vector2d>(const Eigen::Vector2d&)>, 2>
      ideal_from_image;
};

/// The agreement of the points of a pair with its cameras. Each distance is the mean of the
/// distances in both images.
struct PairFit {
  std::size_t n_points = 0;  ///< number of points within the known fields of both cameras
  /// Median distance of a point from the epipolar line of its counterpart, px; NaN without points.
  double median_y_parallax_px = 0.0;
  /// Share in [0, 1] of the points whose distance from the part of the epipolar line within the
  /// height range is at most the limit.
  double share_that_fits = 0.0;
};

/// Computes the agreement of the points of a pair with its cameras.
/// @param limit_px  largest distance of a point that is included in share_that_fits
PairFit fit_of_pair(std::span<const PointMatch> points,
                    const PairGeometry& geometry,
                    double limit_px);

/// A possible difference between the files of a pair and the images taken by its cameras.
struct PairReading {
  bool swapped = false;
  std::array<int, 2> turned_deg{0, 0};  ///< rotation of the file, clockwise: 0, 90, 180, 270
  /// 0.5: each side of the file has half as many pixels as the camera's image.
  std::array<double, 2> scale{1.0, 1.0};
};

/// Converts the pixels of a point in the files to pixels of the cameras. `sizes_px`: width and
/// height of the files.
PointMatch as_seen(const PointMatch& file_points,
                   const std::array<Eigen::Vector2i, 2>& sizes_px,
                   const PairReading& reading);

/// The readings, other than leaving the files as they are, under which at least half of the points
/// fit, and nearly as many as under the best reading. There may be several: if the epipolar lines
/// are parallel, swapped images cannot be distinguished from images that are both rotated by 180
/// degrees. Simple readings come first. The readings tried are: swapped; one or both rotated by the
/// same angle; one or both of half or double size.
std::vector<PairReading> fitting_readings(std::span<const PointMatch> points,
                                          const std::array<Eigen::Vector2i, 2>& sizes_px,
                                          const PairGeometry& geometry,
                                          double limit_px);

}  // namespace ridgeline::reconstruct
