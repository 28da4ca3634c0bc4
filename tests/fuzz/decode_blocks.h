// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/cloud_source.h"

#include <algorithm>
#include <vector>

namespace ridgeline::io::fuzz {

/// Decodes the first blocks of a cloud: a stream of repetitions is small and long at once, and a
/// fuzzer needs short runs.
inline void decode_blocks(const CloudSource& source) {
  constexpr std::size_t kMaxBlocks = 3;
  constexpr std::size_t kMaxBlockPoints = 20'000;
  if (source.max_block_points() > kMaxBlockPoints) return;
  std::vector<CloudPoint> points;
  for (std::size_t block = 0; block < std::min(kMaxBlocks, source.n_blocks()); ++block) {
    source.decode_block(block, {}, points);
  }
}

}  // namespace ridgeline::io::fuzz
