// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/extensions.h"

#include "reconstruct/estimate/beyond/depth_consensus/consensus_support.h"
#include "reconstruct/estimate/beyond/network/network_lines.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

EstimateExtensions estimate_extensions(const EstimationOptions& options,
                                       const SurfaceOf& surface_of) {
  EstimateExtensions beyond;
  beyond.common_part = options.beyond.common_part;
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
