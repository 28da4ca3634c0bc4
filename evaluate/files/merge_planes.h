// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/merge_cells.h"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace ridgeline::results {

// Parts of merge_cells().

/// An edge or plane that reaches this close to the border of its cell's box is cut there, because
/// what it borders on is not known.
inline constexpr double kCutReach_m = 3.0;

/// The number of each cell in the list.
std::map<MapCell, std::size_t> numbers_of(const std::vector<FoundInCell>& cells);

/// Calls `visit(i, k)` for each pair of cells in the list that share a side or a corner.
template <typename Visit>
void for_each_neighbours(const std::vector<FoundInCell>& cells, const Visit& visit) {
  const std::map<MapCell, std::size_t> numbers = numbers_of(cells);
  for (const auto& [cell, i] : numbers) {
    for (const auto& [row, column] : {std::pair{0, 1}, {1, -1}, {1, 0}, {1, 1}}) {
      const auto it = numbers.find({cell.row + row, cell.column + column});
      if (it != numbers.end()) visit(i, it->second);
    }
  }
}

/// The planes of all cells after merging.
struct MergedPlanes {
  struct Plane {
    evaluate::ScanPlane plane;
    bool belongs = false;  ///< to a cell; otherwise it is only kept if an edge bounds it
  };
  std::vector<Plane> planes;
  /// By cell and plane: its index in `planes`.
  std::vector<std::vector<std::size_t>> index;
};

/// `cells` in ascending order.
MergedPlanes merge_planes(const std::vector<FoundInCell>& cells, const MapCell& base);

}  // namespace ridgeline::results
