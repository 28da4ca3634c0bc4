// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/beyond/options.h"
#include "reconstruct/extract/ok2011/extract_segments.h"

namespace ridgeline::reconstruct {

/// The extensions of the extraction that the options switch on: a second look for faint edges
/// (faint_edges), cuts of edges where others end on them (junction_cuts), and the separation of
/// edges that blur into one (close_edges).
EdgeRefinement edge_refinement(const ExtractionOptions& options);

}  // namespace ridgeline::reconstruct
