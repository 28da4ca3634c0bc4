// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/estimate_extensions.h"

#include "reconstruct/beyond/depth_consensus/consensus_support.h"
#include "reconstruct/beyond/network/network_lines.h"

namespace ridgeline::reconstruct {

EstimateExtensions estimate_extensions(const EstimationOptions& options,
                                       std::span<const FlankStrips> strips) {
  EstimateExtensions beyond;
  beyond.max_end_sigma_m = options.beyond.max_end_sigma_m;
  if (options.beyond.consensus) {
    beyond.support = [options, strips](const StereoLines& lines,
                                       std::span<const ReconstructedLine> direct) {
      return consensus_support(lines, direct, strips, options);
    };
  }
  beyond.network = [options](const StereoLines& lines, std::span<const PairConnection> connections,
                             std::vector<std::vector<JointLine>>& by_match) {
    adjust_together(lines, connections, options, by_match);
  };
  return beyond;
}

}  // namespace ridgeline::reconstruct
