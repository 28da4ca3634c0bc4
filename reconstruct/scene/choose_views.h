// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::reconstruct {

/// A frame that may show a place.
struct CandidateView {
  std::string id;                     ///< tells candidates that are equally good apart
  ProjectionMatrix image_from_local;  ///< ideal pixel
  Eigen::Vector2i size_px;            ///< columns, rows
};

/// Share of the points that the frame shows in front of its camera.
double seen_share(const CandidateView& view, std::span<const Eigen::Vector3d> points_in_local);

/// The views that tell lines at the points best, at most `max_views`; the first two are the base
/// pair.
///
/// The base view sees the most of the points; of those that see equally much, to a tenth, it is the
/// one that looks down most steeply. Then views are added one by one: each time the one that leaves
/// the least uncertainty. That is the mean, over the points and over lines of eight directions in
/// plan, of the logarithm of the trace of the covariance of the line across itself, from the planes
/// of its views of one pixel (Ok et al. 2011, section 3) and a prior of `height_range_m` / 2 in
/// both axes. By the logarithm, half the uncertainty counts the same for lines of every direction;
/// without it the lines along a base, of which two views tell no depth, would decide alone. A view
/// whose base-to-height ratio to all views chosen so far is above 0.6 shows surfaces too
/// differently to be matched; it is taken only if there is no other. Views that see less than a
/// tenth of the points, or stand in the place of a chosen one (ratio below 0.02), are left out. The
/// order of the candidates does not matter.
/// @return numbers of candidates, perhaps none
std::vector<std::size_t> choose_views(std::span<const CandidateView> candidates,
                                      std::span<const Eigen::Vector3d> points_in_local,
                                      double height_range_m,
                                      std::size_t max_views);

}  // namespace ridgeline::reconstruct
