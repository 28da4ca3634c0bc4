// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/scene/scene.h"

#include <functional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The segments of a view in its pixels, found with this smoothing of the gradient.
using Extraction =
    std::function<std::vector<EdgeSegment>(const View& view, double gradient_sigma_px)>;

/// The segments of the views of one place, found at the size and with the smoothing that their
/// edges ask for. Lens, demosaicing, compression, haze and motion spread an edge over several
/// pixels.
///
/// The gradient is smoothed about as much as the edges are: with less, noise moves and interrupts
/// them. So where the segments of an image show edges wider than the smoothing was meant for, the
/// image is searched again.
///
/// At full size soft images may show texture more clearly than edges. They are reduced by 2, then
/// by 3, 4, 6 and 8 as long as that makes their long segments longer, all in all, the first time
/// by a fifth. Segments of the finer images are left out, because they are texture. All views have
/// this size in common: an edge that is found at different sizes has different ends and neighbours,
/// and fewer matches. Further reductions bring wider edges. Where several images show one edge, the
/// finest segment that shows it as a whole is taken.
/// @param views              their images are CV_32F
/// @param gradient_sigma_px  the least smoothing, for edges of a sharp image
/// @return by view, in its pixels; EdgeSegment::scale_px states where each was found. For
///         sharp images, what `extract` finds in them
std::vector<std::vector<EdgeSegment>> segments_at_common_size(std::span<const View* const> views,
                                                              double gradient_sigma_px,
                                                              const Extraction& extract);

}  // namespace ridgeline::reconstruct
