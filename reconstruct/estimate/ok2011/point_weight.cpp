// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/point_weight.h"

#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace ridgeline::reconstruct {
namespace {

// Ok et al. 2011, Eq. 6.
constexpr double kSigmaDistance_px = 5.0;    // sigma_1: distance of the two segments
constexpr double kSigmaEpipolar_px = 2.0;    // sigma_2: distance to the epipolar line
constexpr double kMinPointAngle_deg = 10.0;  // t: a pair up to this angle gives no point

bool better(const RankedPoint& a, const RankedPoint& b) {
  return std::tuple(-a.weight, a.omega, a.neighbour) < std::tuple(-b.weight, b.omega, b.neighbour);
}

}  // namespace

PairMeasures smallest_of_each(std::span<const PairMeasures> images) {
  PairMeasures smallest = images.front();
  for (const PairMeasures& image : images.subspan(1)) {
    smallest = {std::min(smallest.distance_px, image.distance_px),
                std::min(smallest.epipolar_distance_px, image.epipolar_distance_px),
                std::min(smallest.angle_rad, image.angle_rad)};
  }
  return smallest;
}

double point_weight(const PairMeasures& measures) {
  const double angle_deg = deg_from_rad(measures.angle_rad);
  if (!(angle_deg > kMinPointAngle_deg)) return 0.0;
  return std::exp(-measures.distance_px / (2.0 * kSigmaDistance_px) -
                  measures.epipolar_distance_px / (2.0 * kSigmaEpipolar_px));
}

Region region(double parameter) {
  if (parameter < 1.0 / 3.0) return Region::kLeft;
  return parameter > 2.0 / 3.0 ? Region::kRight : Region::kCentre;
}

std::vector<std::size_t> select_points(std::span<const RankedPoint> points) {
  std::array<std::optional<std::size_t>, kNumRegions> best;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(points[i].weight > kMinWeight)) continue;
    std::optional<std::size_t>& champion =
        best.at(static_cast<std::size_t>(region(points[i].parameter)));
    if (!champion || better(points[i], points[*champion])) champion = i;
  }
  std::vector<std::size_t> selected;
  for (const std::optional<std::size_t>& champion : best) {
    if (champion) selected.push_back(*champion);
  }
  return selected;
}

}  // namespace ridgeline::reconstruct
