// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/splitmix64.h"

#include <cstdint>
#include <initializer_list>

namespace ridgeline::simulate {

/// SplitMix64 with its own distributions, because those of the standard library differ between
/// implementations. Keyed by any number of integers (seed, strip, pulse, ...), so that each
/// independent output draws from its own stream and no result depends on the number of threads. Put
/// several draws in one expression in braces, which are evaluated in order, unlike function
/// arguments.
class Random : public SplitMix64 {
 public:
  Random(std::initializer_list<std::uint64_t> key);

  double uniform();                         ///< in [0, 1)
  double uniform(double low, double high);  ///< in [low, high)
  int integer(int low, int high);           ///< in [low, high], both included
  bool chance(double probability);          ///< true with this probability
  double normal();                          ///< mean 0, standard deviation 1 (Box-Muller)
};

}  // namespace ridgeline::simulate
