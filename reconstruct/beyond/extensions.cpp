// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/extensions.h"

#include "reconstruct/beyond/close_edges/close_lines.h"
#include "reconstruct/beyond/close_edges/separate_edges.h"
#include "reconstruct/beyond/depth_consensus/consensus_support.h"
#include "reconstruct/beyond/faint_edges/faint_edges.h"
#include "reconstruct/beyond/hidden_walls/hidden_strips.h"
#include "reconstruct/beyond/hidden_walls/side_past_wall.h"
#include "reconstruct/beyond/junction_cuts/junctions.h"
#include "reconstruct/beyond/matched_radiometry/matched_radiometry.h"
#include "reconstruct/beyond/network/network_lines.h"
#include "reconstruct/beyond/surface/surface_candidates.h"

#include <utility>

namespace ridgeline::reconstruct {

EdgeRefinement edge_refinement(const ExtractionOptions& options) {
  return [options](std::vector<EdgeTrace> edges, const ImagePart& image) {
    if (options.beyond.faint_edges) edges = with_faint_edges(std::move(edges), image, options);
    if (options.beyond.junction_cuts) edges = cut_at_junctions(std::move(edges), options);
    if (options.beyond.separate_edges) edges = separate_edges(std::move(edges), image.pixels);
    return edges;
  };
}

MatchExtensions match_extensions(const MatchExtensionOptions& options,
                                 const CandidateOptions& candidates,
                                 const Surface* surface) {
  MatchExtensions beyond;
  if (options.hidden_walls) beyond.look = look_past_wall;
  if (options.matched_radiometry) {
    beyond.radiometry = [candidates, look = beyond.look](const SearchedPair& pair,
                                                         const Radiometry& first) {
      return matched_radiometry(pair, first, candidates, look);
    };
  }
  beyond.candidates = [options, surface](const SearchedPair& pair, const Radiometry& radiometry,
                                         Candidates& found) {
    const std::array<CloseLines, 2> close{close_lines(ideal_segments(pair.left)),
                                          close_lines(ideal_segments(pair.right))};
    if (options.close_lines) keep_order_of_close_lines(pair, close, found);
    if (options.hidden_walls) compare_across_hidden_strips(pair, radiometry, close, found);
    if (options.surface && surface != nullptr)
      weigh_by_surface(*surface, ideal_segments(pair.left), found);
  };
  return beyond;
}

ChioExtensions chio_extensions(const ChioExtensionOptions& options,
                               const CandidateLook& change_look) {
  ChioExtensions beyond{change_look};
  if (options.allow_noise) beyond.noise = NoiseAllowance{options.edge_sigma_px};
  if (options.by_look)
    beyond.by_look = ChoiceByLook{options.min_similarity, options.max_similarity_ratio};
  return beyond;
}

EstimateExtensions estimate_extensions(const EstimationOptions& options,
                                       const SurfaceOf& surface_of) {
  EstimateExtensions beyond;
  beyond.max_end_sigma_m = options.beyond.max_end_sigma_m;
  if (options.beyond.consensus) {
    const SurfaceOf used = options.beyond.surface ? surface_of : no_surface;
    beyond.support = [options, used](const TrackedLines& lines,
                                     std::span<const ReconstructedLine> direct) {
      return consensus_support(lines, direct, used, options);
    };
  }
  beyond.network = [options](const TrackedLines& lines, std::span<const PairConnection> connections,
                             std::vector<std::vector<JointLine>>& by_track) {
    adjust_together(lines, connections, options, by_track);
  };
  return beyond;
}

}  // namespace ridgeline::reconstruct
