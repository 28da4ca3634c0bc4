// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/occupied_cells.h"

#include <bit>
#include <cmath>

namespace ridgeline::io {

void OccupiedCells::add(double x, double y) {
  constexpr double kLimitM = 1e9;  // keeps the cell indices in 32 bits
  if (!(std::abs(x) < kLimitM && std::abs(y) < kLimitM)) return;
  // Indices are taken modulo 2^32, so that negative ones keep their order within a tile.
  const auto column = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(x)));
  const auto row = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(y)));
  const std::uint64_t tile = std::uint64_t{column >> 3U} << 32U | row >> 3U;
  tiles_[tile] |= std::uint64_t{1} << ((column & 7U) << 3U | (row & 7U));
}

void OccupiedCells::merge(const OccupiedCells& other) {
  for (const auto& [tile, cells] : other.tiles_) tiles_[tile] |= cells;
}

std::uint64_t OccupiedCells::count() const {
  std::uint64_t sum = 0;
  for (const auto& [tile, cells] : tiles_) sum += static_cast<std::uint64_t>(std::popcount(cells));
  return sum;
}

}  // namespace ridgeline::io
