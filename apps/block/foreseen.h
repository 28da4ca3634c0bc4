// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace ridgeline::apps {

/// What a task is expected to need.
struct Foreseen {
  double seconds = 0.0;  ///< of processor time
  double memory_mib = 0.0;
};

/// Measured on simulated villages and real frames with the default options; roofs close together take up to twice as long, woods
/// half of it. `windows_mpx`: of all images of the patch.
constexpr Foreseen foreseen_of(double windows_mpx, std::size_t n_images) {
  constexpr double kSecondsPerMpx = 3.0;
  constexpr double kMibPerMpx = 70.0;
  constexpr double kProgram_mib = 120.0;
  (void)n_images;
  return {kSecondsPerMpx * windows_mpx, kProgram_mib + kMibPerMpx * windows_mpx};
}

}  // namespace ridgeline::apps
