// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

namespace ridgeline::simulate {

/// Sub-pixel positions are multiples of 1/kSubPixels, counted from the left or upper border.
inline constexpr int kSubPixels = 256;

/// The ray positions within a pixel: a lattice in which no two rays share a column or a row, so
/// that an edge parallel to the rows is resolved to 1/n of a pixel for n rays.
struct SubPixelLattice {
  explicit SubPixelLattice(int samples_per_side);
  struct Position {
    int x, y;  ///< in [0, kSubPixels)
  };
  std::vector<Position> positions;
};

/// A sampled Gaussian point spread function: the contribution of a ray at a sub-pixel position to
/// the surrounding pixels, along one axis.
class PointSpread {
 public:
  static constexpr int kReachPx = 2;
  using Weights = std::array<float, 2 * kReachPx + 1>;  ///< weights of the pixels -2 ... +2

  explicit PointSpread(double sigma_px);
  [[nodiscard]] const Weights& at(int sub_pixel) const {
    return table_[static_cast<std::size_t>(sub_pixel)];
  }

 private:
  std::array<Weights, kSubPixels> table_;
};

}  // namespace ridgeline::simulate
