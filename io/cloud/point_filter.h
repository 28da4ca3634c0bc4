// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/local_from_file.h"
#include "io/cloud/point_cloud.h"
#include "io/cloud/read_cloud.h"

#include <bitset>
#include <cstdint>
#include <vector>

namespace ridgeline::io {

/// Numbers of points dropped, by the first reason that applied.
struct DropCounts {
  std::uint64_t non_finite = 0;
  std::uint64_t withheld = 0;
  std::uint64_t classification = 0;
  std::uint64_t not_last_return = 0;
  std::uint64_t outside = 0;
  std::uint64_t share = 0;
};

/// Applies the selection rules of ReadOptions to points in local metres. The options must outlive
/// the filter.
class PointFilter {
 public:
  /// `local_from_file` converts the bounds of the options.
  PointFilter(const ReadOptions& options, const LocalFromFile& local_from_file);

  /// Removes the points that are not kept; the order of the others is preserved.
  DropCounts apply(std::vector<CloudPoint>& points) const;

  /// Whether no point of this box, in local metres, can be inside the bounds and the mask.
  [[nodiscard]] bool excludes(const Eigen::AlignedBox3d& box_in_local) const;

 private:
  /// The count to which a point is added, or nullptr if it is kept.
  [[nodiscard]] std::uint64_t DropCounts::*reason_to_drop(const CloudPoint& point) const;
  [[nodiscard]] bool is_outside(const CloudPoint& point) const;
  [[nodiscard]] bool is_left_out(const CloudPoint& point) const;

  std::bitset<256> kept_classes_;
  bool exclude_withheld_;
  bool last_returns_;
  std::optional<Eigen::AlignedBox3d> bounds_in_local_;
  const PlanMask* near_;
  double share_;
};

}  // namespace ridgeline::io
