// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// Finds segments by place: an R-tree over their axis-parallel boxes, so that a few segments far
/// away cost nothing. `Segment` is Segment2 or Segment3. Copies share the tree.
template <typename Segment>
class SegmentTree {
 public:
  /// Segments with a coordinate that is not finite are never found.
  explicit SegmentTree(std::span<const Segment> segments);

  /// Indices, in ascending order, of the segments whose boxes come within `reach` of the box of
  /// `segment`; none if `segment` has a coordinate that is not finite.
  [[nodiscard]] std::vector<std::size_t> near(const Segment& segment, double reach) const;

 private:
  struct Boxes;
  std::shared_ptr<const Boxes> boxes_;
};

extern template class SegmentTree<Segment2>;
extern template class SegmentTree<Segment3>;

}  // namespace ridgeline::evaluate
