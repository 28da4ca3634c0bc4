// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// The nearest neighbours of each point, itself included, nearest first; at equal distances the one
/// with the lower index first.
class PointNeighbours {
 public:
  PointNeighbours(std::size_t n_points, std::size_t per_point)
      : per_point_(per_point), indices_(n_points * per_point) {}

  [[nodiscard]] std::size_t per_point() const { return per_point_; }
  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t i) const {
    return std::span(indices_).subspan(i * per_point_, per_point_);
  }
  [[nodiscard]] std::span<std::uint32_t> of(std::size_t i) {
    return std::span(indices_).subspan(i * per_point_, per_point_);
  }

 private:
  std::size_t per_point_;
  std::vector<std::uint32_t> indices_;
};

/// Searches a grid of cells in plan with about two points each, ring by ring.
/// @param points  finite; more than `per_point` of them
PointNeighbours nearest_neighbours(std::span<const Eigen::Vector3d> points, std::size_t per_point);

/// A function like nearest_neighbours(), for example with a search of PCL.
using NeighbourSearch =
    std::function<PointNeighbours(std::span<const Eigen::Vector3d> points, std::size_t per_point)>;

}  // namespace ridgeline::evaluate
