// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/random.h"

#include <cmath>
#include <numbers>

namespace ridgeline::simulate {
namespace {

std::uint64_t state_of(std::initializer_list<std::uint64_t> key) {
  std::uint64_t state = 0;
  for (const std::uint64_t part : key)
    state = SplitMix64::mix(state + SplitMix64::kStep + SplitMix64::mix(part));
  return state;
}

}  // namespace

Random::Random(std::initializer_list<std::uint64_t> key) : SplitMix64(state_of(key)) {}

double Random::uniform() {
  constexpr double kTwoToMinus53 = 1.0 / 9007199254740992.0;
  return static_cast<double>(next() >> 11U) * kTwoToMinus53;
}

double Random::uniform(double low, double high) { return low + (high - low) * uniform(); }

int Random::integer(int low, int high) {
  return low + static_cast<int>(uniform() * static_cast<double>(high - low + 1));
}

bool Random::chance(double probability) { return uniform() < probability; }

double Random::normal() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));  // 1 - u is never 0
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

}  // namespace ridgeline::simulate
