// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/ok2011/extract/extract_segments.h"

namespace ridgeline::reconstruct {

/// What goes beyond the paper in the extraction, as the options switch it on: edges are cut where others end on them
/// (junction_cuts) and edges that blur into one are resolved (close_edges). Empty if both are off.
EdgeRefinement edge_refinement(const ExtractOptions& options);

}  // namespace ridgeline::reconstruct
