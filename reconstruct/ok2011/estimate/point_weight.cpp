// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/ok2011/estimate/point_weight.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

namespace ridgeline::reconstruct {
namespace {

bool better(const RankedPoint& a, const RankedPoint& b) {
  return std::tuple(-a.weight, a.omega, a.neighbour) < std::tuple(-b.weight, b.omega, b.neighbour);
}

}  // namespace

PairMeasures smaller_of_each(const std::array<PairMeasures, 2>& images) {
  return {std::min(images[0].distance_px, images[1].distance_px),
          std::min(images[0].epipolar_distance_px, images[1].epipolar_distance_px),
          std::min(images[0].angle_rad, images[1].angle_rad)};
}

double point_weight(const PairMeasures& measures, const ReconstructOptions& options) {
  const double angle_deg = measures.angle_rad * 180.0 / std::numbers::pi;
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
