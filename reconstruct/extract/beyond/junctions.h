// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/beyond/options.h"
#include "reconstruct/extract/ok2011/edge_segments.h"

#include <vector>

namespace ridgeline::reconstruct {

/// Cuts edges at points where other edges end on them and they change their course, even by only a
/// tenth of a pixel. Examples are the two verges of a gable below the end of its ridge, and the
/// eaves of a stepped terrace between the party walls. In aerial images these form one line to
/// within a fraction of a pixel although they are metres apart in height. A bend where no other
/// edge ends is weaker evidence (bends()), because changing colours next to an edge also shift it.
///
/// An edge is first cut at all its junctions. Neighbouring parts are then joined again unless two
/// lines fit better than one by 0.05 px (root mean square) and by more than the scatter explains;
/// the parts that one line fits best are joined first. Each part is at least 2.5 times
/// min_length_px long.
std::vector<EdgeTrace> cut_at_junctions(std::vector<EdgeTrace> edges,
                                        const ExtractionOptions& options);

}  // namespace ridgeline::reconstruct
