// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/views/scene.h"

#include <functional>
#include <vector>

namespace ridgeline::reconstruct {

/// The segments of a view in its pixels, found with this smoothing of the gradient.
using Extraction =
    std::function<std::vector<EdgeSegment>(const View& view, double gradient_sigma_px)>;

/// The segments of a view, each at the scale of its edge. Lens, demosaicing, compression, haze and
/// motion spread an edge over several pixels.
///
/// The gradient is smoothed about as much as the edges are: with less, noise moves and interrupts
/// them. So where the segments of an image show edges wider than the smoothing was meant for, the
/// image is searched again.
///
/// At full size a soft image may show its texture more clearly than its edges. It is reduced by
/// halves as long as that makes its long segments longer by a fifth, all in all. Segments of the
/// finer images are left out, because they are texture. Further halves bring wider edges. Where
/// several images show one edge, the finest segment that shows it as a whole is taken.
/// @param view               its image is CV_32F
/// @param gradient_sigma_px  the least smoothing, for edges of a sharp image
/// @return in the pixels of the view; EdgeSegment::scale_px states where each was found. For a sharp image, what
///         `extract` finds in it
std::vector<EdgeSegment> segments_at_their_scales(const View& view,
                                                  double gradient_sigma_px,
                                                  const Extraction& extract);

}  // namespace ridgeline::reconstruct
