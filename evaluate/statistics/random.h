// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/splitmix64.h"

#include <cstdint>

namespace ridgeline::evaluate {

/// Random numbers keyed by (seed, stream): streams do not depend on the order in which threads use
/// them.
class KeyedRandom : public SplitMix64 {
 public:
  KeyedRandom(std::uint64_t seed, std::uint64_t stream)
      : SplitMix64(mix(mix(seed + kStep) ^ (stream * kStep))) {}

  /// Uniform in [0, n) for 0 < n < 2^32; the bias is below n / 2^32.
  std::uint64_t below(std::uint64_t n) { return ((next() >> 32U) * n) >> 32U; }
};

}  // namespace ridgeline::evaluate
