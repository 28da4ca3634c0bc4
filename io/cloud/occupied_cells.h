// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_map>

namespace ridgeline::io {

/// The cells of 1 m in plan that hold points, for the density of a cloud of any extent.
class OccupiedCells {
 public:
  /// Adds the cell of a place, metres. Coordinates beyond 1e9 m are damage and are left out.
  void add(double x, double y);
  void merge(const OccupiedCells& other);
  [[nodiscard]] std::uint64_t count() const;

 private:
  /// Key: the indices of a tile of 8 x 8 cells; value: one bit a cell.
  std::unordered_map<std::uint64_t, std::uint64_t> tiles_;
};

}  // namespace ridgeline::io
