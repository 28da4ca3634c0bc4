// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/edge_segments.h"
#include "reconstruct/extract/ok2011/image_part.h"
#include "reconstruct/extract/ok2011/options.h"
#include "reconstruct/geometry/edge_segment.h"

#include <opencv2/core/mat.hpp>

#include <functional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The straight edges of an image, longest first, without those that are already known. `image`:
/// not empty.
std::vector<EdgeTrace> edge_traces(const ImagePart& image,
                                   const ExtractOptions& options,
                                   std::span<const EdgeTrace> known = {});

/// Modifies detected edges before they are turned into segments; extensions beyond the paper are
/// plugged in here. The edges are in pixels of the image file.
using EdgeRefinement =
    std::function<std::vector<EdgeTrace>(std::vector<EdgeTrace>, const ImagePart& image)>;

/// The straight edges of an image with their uncertainty (Ok et al. 2011, section 2), in a
/// fixed order. An image without texture has none.
/// `image`: not empty. Throws std::invalid_argument if the image has a different type or an option
/// is out of range.
std::vector<EdgeSegment> extract_segments(const ImagePart& image,
                                          const PixelMap& ideal_from_image = {},
                                          const ExtractOptions& options = {},
                                          const EdgeRefinement& refine = {});

}  // namespace ridgeline::reconstruct
