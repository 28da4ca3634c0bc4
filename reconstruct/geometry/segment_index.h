// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Finds image segments by place: a grid whose cells list the segments that run through them.
class SegmentIndex {
 public:
  explicit SegmentIndex(std::span<const Segment2> segments);

  /// The segments that may run through the box, in ascending order, each once. The result has all
  /// segments that do and some that only pass nearby.
  [[nodiscard]] std::vector<int> in_box(const Eigen::AlignedBox2d& box) const;
  /// The segments that may run through the bounding box of a segment, grown by a margin, as
  /// in_box() finds them.
  [[nodiscard]] std::vector<int> near(const Segment2& segment, double margin_px) const;

 private:
  [[nodiscard]] Eigen::Vector2i cell_of(const Eigen::Vector2d& x) const;

  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();
  Eigen::Vector2i n_cells_ = Eigen::Vector2i::Zero();
  /// Per cell, the index of its first entry in ids_; one more element than there are cells.
  std::vector<std::size_t> first_;
  std::vector<int> ids_;
};

}  // namespace ridgeline::reconstruct
