// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/options.h"
#include "reconstruct/ok2011/extract/extract_segments.h"

namespace ridgeline::reconstruct {

/// What goes beyond the paper in the extraction, as the options switch it on: a second look for faint edges
/// (faint_edges), edges are cut where others end on them (junction_cuts) and edges that blur into one are resolved
/// (close_edges).
EdgeRefinement edge_refinement(const ExtractionOptions& options);

}  // namespace ridgeline::reconstruct
