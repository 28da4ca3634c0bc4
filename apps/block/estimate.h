// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace ridgeline::apps {

/// The expected resources of a step.
struct TaskEstimate {
  double seconds = 0.0;  ///< processor time
  double memory_mib = 0.0;
};

/// Estimate for a reconstruction task with one thread and the default options. Simulated villages
/// took 1.4 to 3.0 s and 25 to 33 MiB per megapixel. `windows_mpx`: total of all images of the
/// patch.
constexpr TaskEstimate estimate_of_patch(double windows_mpx) {
  constexpr double kSecondsPerMpx = 2.0;
  constexpr double kMibPerMpx = 40.0;
  constexpr double kProgramMib = 120.0;
  return {kSecondsPerMpx * windows_mpx, kProgramMib + kMibPerMpx * windows_mpx};
}

/// Judging takes most of the time. `n_patches`: in the block, with a few hundred lines each.
/// `lidar_bytes`: total of all files of the cloud, which is read block by block.
constexpr TaskEstimate estimate_of_merge(std::size_t n_patches, std::uint64_t lidar_bytes) {
  constexpr double kSecondsPerPatch = 0.5;
  constexpr double kBytesPerSecond = 40e6;  // LAZ; LAS is read faster
  constexpr double kMibPerPatch = 8.0;
  constexpr double kProgramMib = 600.0;
  const auto n = static_cast<double>(n_patches);
  return {kSecondsPerPatch * n + static_cast<double>(lidar_bytes) / kBytesPerSecond,
          kProgramMib + kMibPerPatch * n};
}

}  // namespace ridgeline::apps
