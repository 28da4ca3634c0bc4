// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/nominal_pair.h"

#include <numbers>

namespace ridgeline::simulate {
namespace {

constexpr double kFocalLength_px = 10000.0;
constexpr double kHeightAboveGround_m = 800.0;
constexpr double kBaseToHeight = 0.26;
constexpr double kAligned_deg = 10.0;

/// Looking straight down, image x along world x, image y against world y.
ProjectionMatrix vertical_camera(const Eigen::Vector3d& centre) {
  ProjectionMatrix p = ProjectionMatrix::Zero();
  p(0, 0) = kFocalLength_px;
  p(1, 1) = -kFocalLength_px;
  p(2, 2) = -1.0;
  p.col(3) = -p.leftCols<3>() * centre;
  return p;
}

}  // namespace

std::array<ProjectionMatrix, 2> nominal_pair(const Scene& scene) {
  const Eigen::Vector3d middle = scene.frame.world_from_local(
      {0.5 * scene.extent_m.x(), 0.5 * scene.extent_m.y(), kHeightAboveGround_m});
  const Eigen::Vector3d half_base(0.5 * kBaseToHeight * kHeightAboveGround_m, 0.0, 0.0);
  return {vertical_camera(middle - half_base), vertical_camera(middle + half_base)};
}

io::LineSet classed_by_nominal_pair(io::LineSet lines, const Scene& scene) {
  const std::array<ProjectionMatrix, 2> pair = nominal_pair(scene);
  for (io::Line& line : lines.lines) {
    line.epipolar_angle_deg =
        epipolar_angle_rad(pair, line.segment_in_world) * 180.0 / std::numbers::pi;
    line.line_class = *line.epipolar_angle_deg <= kAligned_deg ? "aligned" : "not_aligned";
  }
  return lines;
}

}  // namespace ridgeline::simulate
