// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace ridgeline {

/// Finds boxes in plan by place: square cells list the boxes that touch them. Boxes may lie
/// anywhere and have any size.
class BoxIndex {
 public:
  /// Empty boxes, and those with a coordinate that is not finite, are never found.
  explicit BoxIndex(std::vector<Eigen::AlignedBox2d> boxes);

  /// The places of all boxes that are at most `reach` from `box`, sorted.
  [[nodiscard]] std::vector<std::size_t> near(const Eigen::AlignedBox2d& box, double reach) const;

 private:
  using Cell = std::pair<long, long>;

  std::vector<Eigen::AlignedBox2d> boxes_;
  std::map<Cell, std::vector<std::size_t>> in_cell_;
  std::vector<std::size_t> wide_;  ///< boxes over too many cells
};

/// The box around the plan view of points; empty if one is not finite.
Eigen::AlignedBox2d plan_box_of(std::span<const Eigen::Vector3d> points);

}  // namespace ridgeline
