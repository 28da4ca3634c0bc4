// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/footprint.h"
#include "reconstruct/geometry/plane.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// Points of a zone sorted into square cells along the footprint's axes, so that a surface can be
/// followed from cell to cell. Refers to the zone, which must outlive it.
class ZoneCells {
 public:
  ZoneCells(std::span<const ZonePoint> zone, double cell_m) : zone_(zone), cell_m_(cell_m) {
    for (const ZonePoint& p : zone) {
      lowest_s_ = std::min(lowest_s_, p.s);
      lowest_t_ = std::min(lowest_t_, p.t);
      highest_s_ = std::max(highest_s_, p.s);
      highest_t_ = std::max(highest_t_, p.t);
    }
    columns_ = static_cast<int>((highest_s_ - lowest_s_) / cell_m_) + 1;
    rows_ = static_cast<int>((highest_t_ - lowest_t_) / cell_m_) + 1;
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::uint32_t i = 0; i < zone.size(); ++i) cells_[cell_of(zone[i])].push_back(i);
  }

  [[nodiscard]] std::size_t cell_of(const ZonePoint& p) const {
    const int column = static_cast<int>((p.s - lowest_s_) / cell_m_);
    const int row = static_cast<int>((p.t - lowest_t_) / cell_m_);
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  /// The zone's points on the plane that are connected to a seed through neighbouring cells, in the
  /// order in which the cells are reached.
  [[nodiscard]] std::vector<ZonePoint> connected_inliers(std::span<const ZonePoint> seeds,
                                                         const Plane3& plane,
                                                         double distance_m) const {
    std::vector<char> reached(cells_.size(), 0);
    std::vector<std::size_t> front;
    for (const ZonePoint& seed : seeds) reach(cell_of(seed), reached, front);
    const std::size_t n_seed_cells = front.size();
    std::vector<ZonePoint> inliers;
    for (std::size_t next = 0; next < front.size(); ++next) {
      const std::size_t cell = front[next];
      const std::size_t before = inliers.size();
      for (const std::uint32_t i : cells_[cell]) {
        if (plane.absDistance(zone_[i].x) <= distance_m) inliers.push_back(zone_[i]);
      }
      // a wall or a tree that crosses the plane does not connect it to what lies beyond
      const auto in_plane = static_cast<double>(inliers.size() - before);
      if (in_plane < kOwnCell * static_cast<double>(cells_[cell].size()) && next >= n_seed_cells) {
        inliers.resize(before);
      } else if (in_plane > 0.0) {
        reach_neighbours(cell, reached, front);
      }
    }
    return inliers;
  }

 private:
  static constexpr double kOwnCell = 0.4;  ///< minimum share of a cell's points on the plane

  static void reach(std::size_t cell, std::vector<char>& reached, std::vector<std::size_t>& front) {
    if (reached[cell] != 0) return;
    reached[cell] = 1;
    front.push_back(cell);
  }
  void reach_neighbours(std::size_t cell,
                        std::vector<char>& reached,
                        std::vector<std::size_t>& front) const {
    const int row = static_cast<int>(cell / static_cast<std::size_t>(columns_));
    const int column = static_cast<int>(cell % static_cast<std::size_t>(columns_));
    for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r) {
      for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c) {
        reach(static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(c),
              reached, front);
      }
    }
  }

  std::span<const ZonePoint> zone_;
  double cell_m_;
  double lowest_s_ = HUGE_VAL, lowest_t_ = HUGE_VAL, highest_s_ = -HUGE_VAL, highest_t_ = -HUGE_VAL;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace ridgeline::evaluate
