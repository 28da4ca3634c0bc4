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

/// Spatial index of axis-parallel boxes, or of segments by their bounding boxes. It is an R-tree,
/// so that a few distant boxes do not slow it down. Copies share the tree.
template <int kDim>
class BoxIndex {
 public:
  using Box = Eigen::AlignedBox<double, kDim>;
  using Segment = std::conditional_t<kDim == 2, Segment2, Segment3>;

  BoxIndex() = default;
  /// Empty boxes and boxes with a non-finite coordinate are never found.
  explicit BoxIndex(std::span<const Box> boxes);
  explicit BoxIndex(std::span<const Segment> segments);

  /// The indices, in ascending order, of all boxes at most `reach` away from `box`; none if `box`
  /// is empty or not finite.
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

/// The bounding box of the points in plan; empty if any point is not finite.
Eigen::AlignedBox2d plan_box_of(std::span<const Eigen::Vector3d> points);

}  // namespace ridgeline
