// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/scan_edges.h"

#include <Eigen/Geometry>

#include <compare>
#include <cstdint>
#include <vector>

namespace ridgeline::results {

/// Cells of the map are squares of this size; their corners are whole multiples of it.
inline constexpr std::int64_t kCell_m = 100;
/// What is found in a cell is found with the points up to this distance outside it, in x and in y.
inline constexpr std::int64_t kCellMargin_m = 30;

struct MapCell {
  std::int64_t row = 0, column = 0;
  auto operator<=>(const MapCell&) const = default;
};

/// The square of a cell, grown by `margin_m` on all sides, in a frame whose origin is the lower
/// corner of `base`. Metres.
Eigen::AlignedBox2d box_of(const MapCell& cell, const MapCell& base, double margin_m);

/// What was found in a cell with its margin.
struct FoundInCell {
  MapCell cell;
  evaluate::ScanEdges found;
};

/// Merges what neighbouring cells found; all coordinates are in the frame of box_of() with the same
/// `base`. The cells may be in any order, but each only once.
///
/// An edge that ends at least 3 m inside the box of its cell and margin is whole and belongs to the
/// cell of its middle; other edges are cut at the borders of their cells. Edges of neighbouring
/// cells are the same if they overlap over half of the shorter one within 0.3 m and 3 degrees, and
/// pieces that continue each other across a border are joined: ends from the outermost pieces with
/// their covariance, support and `moved_out_m` averaged by length, the rest from the longest. Of
/// several whole ones, that of the lowest cell is kept. Planes are the same if half of the outline
/// of one in the box that both cells see lies within 0.15 m and 5 degrees of the other. A plane
/// that reaches over several cells has the fit of its largest part and the rings of all parts, cut
/// at the borders of their cells. Planes and edges are in the order of their cells.
evaluate::ScanEdges merge_cells(std::vector<FoundInCell> cells, const MapCell& base);

}  // namespace ridgeline::results
