// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/scene/scene.h"

#include <functional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Finds the segments of a view, in its pixels, with the given smoothing of the gradient.
using Extraction =
    std::function<std::vector<EdgeSegment>(const View& view, double gradient_sigma_px)>;

/// The segments of the views of one place, found at the image size and with the smoothing that suit
/// the width of their edges. Lens, demosaicing, compression, haze and motion spread an edge over
/// several pixels.
///
/// The gradient is smoothed by about as much as the edges are blurred; with less smoothing, noise
/// shifts and interrupts them. If the segments of an image show that its edges are wider than the
/// smoothing assumed, the image is therefore searched again.
///
/// At full size, soft images may show texture more clearly than edges. They are reduced by 2, then
/// by 3, 4, 6 and 8, as long as this increases the total length of their long segments, the first
/// time by a fifth. Segments of the finer images are left out, because they are texture. All views
/// are reduced to the same size, because an edge found at different sizes has different ends and
/// neighbours, and fewer matches. Further reductions add wider edges. If an edge is found at
/// several sizes, the finest segment that shows it completely is used.
/// @param views              their images are CV_32F
/// @param gradient_sigma_px  minimum smoothing, for the edges of a sharp image
/// @return by view, in its pixels; EdgeSegment::scale_px gives the scale at which each segment was
///         found. For sharp images, the result of `extract`
std::vector<std::vector<EdgeSegment>> segments_at_common_size(std::span<const View* const> views,
                                                              double gradient_sigma_px,
                                                              const Extraction& extract);

}  // namespace ridgeline::reconstruct
