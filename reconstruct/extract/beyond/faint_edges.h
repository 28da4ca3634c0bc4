// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/beyond/options.h"
#include "reconstruct/extract/ok2011/extract_segments.h"

#include <vector>

namespace ridgeline::reconstruct {

/// The known edges, followed by those that a second look with more smoothing finds beside them.
/// Ridges and hips between faces of nearly the same colour are too faint for the first look. There
/// is no second look if the first one was about as smooth, as it is in a soft image.
std::vector<EdgeTrace> with_faint_edges(std::vector<EdgeTrace> known,
                                        const ImagePart& image,
                                        const ExtractionOptions& options);

}  // namespace ridgeline::reconstruct
