// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/views/scene.h"

#include <functional>
#include <vector>

namespace ridgeline::reconstruct {

/// The segments of a view in its pixels.
using Extraction = std::function<std::vector<EdgeSegment>(const View& view)>;

/// The segments of a view, each at the scale of its edge. Lens, demosaicing, compression, haze and motion
/// spread an edge over several pixels. At full size such an image shows its texture more clearly than its
/// edges. It is reduced by halves until its edges are sharp: as long as that makes its long segments longer
/// by a fifth, all in all. Segments of the finer images are left out, because they are texture. Further halves
/// bring wider edges. Where several images show one edge, the finest segment that shows it as a whole is
/// taken.
/// @param view    its image is CV_32F
/// @param finest  its segments at full size; they are the result for a sharp image
/// @return in the pixels of the view; EdgeSegment::scale_px states where each was found
std::vector<EdgeSegment> segments_at_their_scales(const View& view,
                                                  std::vector<EdgeSegment> finest,
                                                  const Extraction& extract);

}  // namespace ridgeline::reconstruct
