// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::reconstruct {

/// A frame that may show the place of interest.
struct CandidateView {
  std::string id;                     ///< breaks ties between equally good candidates
  ProjectionMatrix image_from_local;  ///< ideal pixel
  Eigen::Vector2i size_px;            ///< columns, rows
};

/// Share of the points that lie in front of the camera and within the frame.
double seen_share(const CandidateView& view, std::span<const Eigen::Vector3d> points_in_local);

/// The views that best determine lines at the points, at most `max_views`; the first two are the
/// base pair.
///
/// The base view sees the largest share of the points, rounded to tenths; of several such views, it
/// is the one that looks down most steeply. Further views are added one by one, each time the one
/// that leaves the least uncertainty. The uncertainty is the mean, over the points and over lines
/// of eight directions in plan, of the logarithm of the trace of the covariance across the line.
/// This covariance follows from the projection planes of the views, with a sigma of one pixel (Ok
/// et al. 2011, section 3), and a prior of `height_range_m` / 2 in both axes. Because of the
/// logarithm, halving the uncertainty has the same effect for lines of every direction; without it,
/// the lines along a base, whose depth two views cannot determine, would dominate. A view whose
/// base-to-height ratio to all views chosen so far is above 0.6 shows surfaces too differently to
/// be matched; it is used only if there is no other. Views that see less than a tenth of the
/// points, or that are at the position of a chosen one (ratio below 0.02), are left out. The order
/// of the candidates does not matter.
/// @return indices of the chosen candidates, possibly none
std::vector<std::size_t> choose_views(std::span<const CandidateView> candidates,
                                      std::span<const Eigen::Vector3d> points_in_local,
                                      double height_range_m,
                                      std::size_t max_views);

}  // namespace ridgeline::reconstruct
