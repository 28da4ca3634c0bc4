// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_map>

namespace ridgeline::io {

/// The 1 m cells in plan that contain points, for the density of a cloud of any extent.
class OccupiedCells {
 public:
  /// Adds the cell that contains a position, metres. Coordinates beyond 1e9 m are treated as
  /// damaged and ignored.
  void add(double x, double y);
  void merge(const OccupiedCells& other);
  [[nodiscard]] std::uint64_t count() const;

 private:
  /// Key: the indices of a tile of 8 x 8 cells; value: one bit per cell.
  std::unordered_map<std::uint64_t, std::uint64_t> tiles_;
};

}  // namespace ridgeline::io
