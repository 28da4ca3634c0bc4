// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/beyond/options.h"
#include "reconstruct/extract/ok2011/extract_segments.h"

namespace ridgeline::reconstruct {

/// The extensions of the extraction that are enabled by the options: a second pass for faint edges
/// (faint_edges), cutting edges where others end on them (junction_cuts), and separating edges that
/// blur into one (separate_edges).
EdgeRefinement edge_refinement(const ExtractionOptions& options);

}  // namespace ridgeline::reconstruct
