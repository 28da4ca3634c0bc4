// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/patch.h"
#include "reconstruct/views/scene.h"

#include <optional>
#include <string>

namespace ridgeline::apps {

constexpr double kDefaultMaxYParallax_px = 3.0;

/// Checks by points that both images show whether the pair fits its cameras. The points must lie near the epipolar lines of
/// each other (median at most `max_y_parallax_px`; 0: no check) and must not fit far better with the images swapped or
/// turned; otherwise an IoError names what would fit. A warning is returned if too few points are found, as in images
/// without texture, or if most points lie outside the height range of the patch. `scene`: the
/// first two views of the patch in a local frame, with normalised images.
[[nodiscard]] std::optional<std::string> check_pair(const io::PatchFile& patch,
                                                    const reconstruct::Scene& scene,
                                                    double max_y_parallax_px);

}  // namespace ridgeline::apps
