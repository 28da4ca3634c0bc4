// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/beyond/extensions.h"

#include "reconstruct/extract/beyond/close_edges/separate_edges.h"
#include "reconstruct/extract/beyond/faint_edges.h"
#include "reconstruct/extract/beyond/junctions.h"

#include <utility>
#include <vector>

namespace ridgeline::reconstruct {

EdgeRefinement edge_refinement(const ExtractionOptions& options) {
  return [options](std::vector<EdgeTrace> edges, const ImagePart& image) {
    if (options.beyond.faint_edges) edges = with_faint_edges(std::move(edges), image, options);
    if (options.beyond.junction_cuts) edges = cut_at_junctions(std::move(edges), options);
    if (options.beyond.separate_edges) edges = separate_edges(std::move(edges), image.pixels);
    return edges;
  };
}

}  // namespace ridgeline::reconstruct
