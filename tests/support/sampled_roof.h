// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/support/random.h"

#include <Eigen/Core>

#include <cmath>
#include <vector>

namespace ridgeline::test {

/// A gabled roof on flat ground, sampled directly (no rays): the smallest scene with a ridge, eaves
/// and verges whose planes are known. The ridge runs along x from (0, 0) to (length, 0).
struct SampledRoof {
  double length_m = 12.0;
  double half_width_m = 5.0;   ///< from ridge to eave, in plan
  double eave_height_m = 6.0;  ///< above the ground at z = 0
  double slope = 0.5;          ///< height / width
  double margin_m = 8.0;       ///< width of the ground around the roof

  [[nodiscard]] double ridge_height_m() const { return eave_height_m + slope * half_width_m; }
  /// Height of the uppermost surface.
  [[nodiscard]] double height(double x, double y) const {
    const bool on_roof = x >= 0.0 && x <= length_m && std::abs(y) <= half_width_m;
    return on_roof ? ridge_height_m() - slope * std::abs(y) : 0.0;
  }
  /// Vertical component of a roof plane's unit normal.
  [[nodiscard]] double normal_z() const { return 1.0 / std::hypot(1.0, slope); }

  /// Points at random plan positions with the given density and normal noise in height.
  [[nodiscard]] std::vector<Eigen::Vector3d> sample(double points_per_m2,
                                                    double sigma_z_m,
                                                    std::uint64_t seed) const {
    Random random(seed);
    const double width = length_m + 2.0 * margin_m;
    const double depth = 2.0 * (half_width_m + margin_m);
    std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(points_per_m2 * width * depth));
    for (Eigen::Vector3d& p : points) {
      const double x = random.uniform(-margin_m, length_m + margin_m);
      const double y = random.uniform(-half_width_m - margin_m, half_width_m + margin_m);
      p = {x, y, height(x, y) + random.normal(sigma_z_m)};
    }
    return points;
  }
};

}  // namespace ridgeline::test
