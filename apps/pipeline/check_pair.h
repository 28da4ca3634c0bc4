// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"
#include "reconstruct/reconstruct.h"

#include <span>
#include <string>
#include <vector>

namespace ridgeline::apps {

constexpr double kDefaultMaxYParallax_px = 3.0;

/// Checks for each pair, using tie points, whether the images fit their cameras. The points must
/// lie near each other's epipolar lines (median at most `max_y_parallax_px`; 0: no check) and must
/// not fit much better with the images swapped or turned; otherwise throws IoError naming both
/// images and what would fit. `scene`: the views of the patch in a local frame, with normalised
/// images.
/// @return warnings about pairs with too few points, e.g. in images without texture, and pairs with
/// most points outside the height range of the patch
[[nodiscard]] std::vector<std::string> check_pairs(const io::Patch& patch,
                                                   const reconstruct::Scene& scene,
                                                   std::span<const ViewPair> pairs,
                                                   double max_y_parallax_px);

/// Calls check_pairs() for the pairs that are matched with these options.
/// @return also a warning for each image that is in none of these pairs, unless excluded by the
/// options, one if the units are probably not metres, and one for each pair with a base-to-height
/// ratio below 0.05 or above 1
[[nodiscard]] std::vector<std::string> check_matched_pairs(const io::Patch& patch,
                                                           const reconstruct::Scene& scene,
                                                           const reconstruct::Options& options,
                                                           double max_y_parallax_px);

}  // namespace ridgeline::apps
