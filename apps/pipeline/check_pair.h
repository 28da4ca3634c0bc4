// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"
#include "reconstruct/reconstruct.h"

#include <span>
#include <string>
#include <vector>

namespace ridgeline::apps {

constexpr double kDefaultMaxYParallax_px = 3.0;

/// Checks by points that both images of a pair show whether they fit their cameras, pair by pair.
/// The points must lie near the epipolar lines of each other (median at most `max_y_parallax_px`;
/// 0: no check) and must not fit far better with the images swapped or turned; otherwise an IoError
/// names both images and what would fit. `scene`: the views of the patch in a local frame, with
/// normalised images.
/// @return warnings: pairs with too few points, as of images without texture, and pairs most of
/// whose points lie outside
///     the height range of the patch
[[nodiscard]] std::vector<std::string> check_pairs(const io::Patch& patch,
                                                   const reconstruct::Scene& scene,
                                                   std::span<const ViewPair> pairs,
                                                   double max_y_parallax_px);

/// check_pairs() of the pairs that these options match.
/// @return also a warning for each image that is in none of these pairs, unless the options leave
/// it out, one of units
///     that are hardly metres, and one for each pair whose base is below 0.05 or above 1 of the
///     height
[[nodiscard]] std::vector<std::string> check_matched_pairs(const io::Patch& patch,
                                                           const reconstruct::Scene& scene,
                                                           const reconstruct::Options& options,
                                                           double max_y_parallax_px);

}  // namespace ridgeline::apps
