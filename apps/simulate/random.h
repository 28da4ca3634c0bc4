// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <initializer_list>

namespace ridgeline::simulate {

/// A small generator with its own distributions, because those of the standard library differ
/// between implementations. Keyed by any number of integers (seed, strip, pulse, ...), so that each
/// independent output draws from its own stream and no result depends on the number of threads.
/// Several draws in one expression belong in braces, which are evaluated in order; the arguments of
/// a call are not.
/// SplitMix64: Steele, Lea, Flood 2014, Fast splittable pseudorandom number generators.
class Random {
 public:
  Random(std::initializer_list<std::uint64_t> key);

  std::uint64_t next();
  double uniform();                         ///< in [0, 1)
  double uniform(double low, double high);  ///< in [low, high)
  int integer(int low, int high);           ///< in [low, high], both included
  bool chance(double probability);          ///< true with this probability
  double normal();                          ///< mean 0, standard deviation 1 (Box-Muller)

 private:
  std::uint64_t state_ = 0;
};

}  // namespace ridgeline::simulate
