// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/cloud_origin.h"

#include "reconstruct/geometry/median.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ridgeline::io {

namespace {

constexpr std::size_t kSampledBlocks = 4;
constexpr std::size_t kSampledPointsPerBlock = 1024;
constexpr double kOriginGridM = 100.0;

/// Coordinates, by axis, of points spread evenly over the file.
std::array<std::vector<double>, 3> sample(const CloudSource& source,
                                          const Eigen::Vector3d& unit_m) {
  std::array<std::vector<double>, 3> coordinates;
  std::vector<CloudPoint> points;
  const std::size_t n_blocks = source.n_blocks();
  const std::size_t n_sampled = std::min(kSampledBlocks, n_blocks);
  for (std::size_t i = 0; i < n_sampled; ++i) {
    source.decode_block(i * n_blocks / n_sampled, {.unit_m = unit_m}, points);
    const std::size_t step = points.size() / kSampledPointsPerBlock + 1;
    for (std::size_t k = 0; k < points.size(); k += step) {
      const CloudPoint& point = points[k];
      if (!std::isfinite(point.x + point.y + point.z)) continue;
      coordinates[0].push_back(point.x);
      coordinates[1].push_back(point.y);
      coordinates[2].push_back(point.z);
    }
  }
  return coordinates;
}

}  // namespace

std::optional<LocalFrame> origin_of(const CloudSource& source, const Eigen::Vector3d& unit_m) {
  const std::array<std::vector<double>, 3> coordinates = sample(source, unit_m);
  if (coordinates[0].empty()) return std::nullopt;
  LocalFrame frame;
  for (int axis = 0; axis < 3; ++axis) {
    const double centre = upper_median(coordinates[static_cast<std::size_t>(axis)]);
    // Adding 0 turns a rounded -0 into 0, which prints without a sign.
    frame.origin_m[axis] = kOriginGridM * std::round(centre / kOriginGridM) + 0.0;
  }
  return frame;
}

bool has_size_of_degrees(const CloudSource& source) {
  constexpr double kMaxWidth_deg = 0.2;
  const std::array<std::vector<double>, 3> coordinates = sample(source, Eigen::Vector3d::Ones());
  if (coordinates[0].empty()) return false;
  std::array<double, 3> extent{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [lowest, highest] = std::ranges::minmax_element(coordinates[axis]);
    extent[axis] = *highest - *lowest;
    const double limit_deg = axis == 0 ? 180.0 : 90.0;
    if (axis < 2 && std::max(-*lowest, *highest) > limit_deg) return false;
  }
  const double width = std::max(extent[0], extent[1]);
  return width > 0.0 && width < kMaxWidth_deg && extent[2] > width;
}

}  // namespace ridgeline::io
