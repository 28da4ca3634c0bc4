// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/beyond/options.h"
#include "reconstruct/extract/ok2011/extract_segments.h"

#include <vector>

namespace ridgeline::reconstruct {

/// The known edges, followed by additional ones found by a second pass with more smoothing. Ridges
/// and hips between faces of nearly the same colour are too faint for the first pass. There is no
/// second pass if the first one used about the same smoothing, as in a soft image.
std::vector<EdgeTrace> with_faint_edges(std::vector<EdgeTrace> known,
                                        const ImagePart& image,
                                        const ExtractionOptions& options);

}  // namespace ridgeline::reconstruct
