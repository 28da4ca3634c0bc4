// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/point_weight.h"

#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace ridgeline::reconstruct {
namespace {

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

double point_weight(const PairMeasures& measures, const ReconstructOptions& options) {
  const double angle_deg = deg_from_rad(measures.angle_rad);
  if (!(angle_deg > options.min_pair_angle_deg)) return 0.0;
  return std::exp(-measures.distance_px / (2.0 * options.sigma_distance_px) -
                  measures.epipolar_distance_px / (2.0 * options.sigma_epipolar_px));
}

Region region(double parameter) {
  if (parameter < 1.0 / 3.0) return Region::kLeft;
  return parameter > 2.0 / 3.0 ? Region::kRight : Region::kCentre;
}

std::vector<std::size_t> select_points(std::span<const RankedPoint> points,
                                       const ReconstructOptions& options) {
  std::array<std::optional<std::size_t>, kNumRegions> best;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(points[i].weight > options.min_weight)) continue;
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
