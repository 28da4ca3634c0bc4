// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/edge_refinement.h"

#include "reconstruct/beyond/close_edges/separate_edges.h"
#include "reconstruct/beyond/junction_cuts/junctions.h"

#include <utility>

namespace ridgeline::reconstruct {

EdgeRefinement edge_refinement(const ExtractOptions& options) {
  if (!options.junction_cuts && !options.separate_edges) return {};
  return [options](std::vector<DetectedEdge> edges, const cv::Mat& image) {
    if (options.junction_cuts) edges = cut_at_junctions(std::move(edges), options);
    return options.separate_edges ? separate_edges(std::move(edges), image) : edges;
  };
}

}  // namespace ridgeline::reconstruct
