// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {

/// Finds boxes in plan that are near to another one, by square cells.
class FaceIndex {
 public:
  /// Empty boxes are never found.
  explicit FaceIndex(std::span<const Eigen::AlignedBox2d> boxes);

  /// The places of all boxes that are at most `reach_m` from `box`, sorted.
  [[nodiscard]] std::vector<std::size_t> near(const Eigen::AlignedBox2d& box, double reach_m) const;

 private:
  using Cell = std::pair<long, long>;
  template <typename Visitor>
  static void visit_cells(const Eigen::AlignedBox2d& box, Visitor&& visit);

  std::vector<Eigen::AlignedBox2d> boxes_;
  std::map<Cell, std::vector<std::size_t>> in_cell_;
};

}  // namespace ridgeline::evaluate
