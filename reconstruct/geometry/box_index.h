// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace ridgeline {

/// Finds axis-parallel boxes, or segments by the boxes around them, by place: an R-tree, so that a
/// few boxes far away cost nothing. Copies share the tree.
template <int kDim>
class BoxIndex {
 public:
  using Box = Eigen::AlignedBox<double, kDim>;
  using Segment = std::conditional_t<kDim == 2, Segment2, Segment3>;

  BoxIndex() = default;
  /// Empty boxes, and those with a coordinate that is not finite, are never found.
  explicit BoxIndex(std::span<const Box> boxes);
  explicit BoxIndex(std::span<const Segment> segments);

  /// The indices, ascending, of all boxes that are at most `reach` from `box`; none if `box` is
  /// empty or not finite.
  [[nodiscard]] std::vector<std::size_t> near(const Box& box, double reach) const;
  [[nodiscard]] std::vector<std::size_t> near(const Segment& segment, double reach) const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

extern template class BoxIndex<2>;
extern template class BoxIndex<3>;
using BoxIndex2 = BoxIndex<2>;
using BoxIndex3 = BoxIndex<3>;

/// The box around the plan view of points; empty if one is not finite.
Eigen::AlignedBox2d plan_box_of(std::span<const Eigen::Vector3d> points);

}  // namespace ridgeline
