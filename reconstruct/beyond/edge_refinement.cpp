// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/edge_refinement.h"

#include "reconstruct/beyond/close_edges/separate_edges.h"
#include "reconstruct/beyond/faint_edges/faint_edges.h"
#include "reconstruct/beyond/junction_cuts/junctions.h"

#include <utility>

namespace ridgeline::reconstruct {

EdgeRefinement edge_refinement(const ExtractionOptions& options) {
  return [options](std::vector<EdgeTrace> edges, const cv::Mat& image) {
    if (options.beyond.faint_edges) edges = with_faint_edges(std::move(edges), image, options);
    if (options.beyond.junction_cuts) edges = cut_at_junctions(std::move(edges), options);
    if (options.beyond.separate_edges) edges = separate_edges(std::move(edges), image);
    return edges;
  };
}

}  // namespace ridgeline::reconstruct
