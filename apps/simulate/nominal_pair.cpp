// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/nominal_pair.h"

#include "apps/simulate/aerial_pair.h"

#include <numbers>

namespace ridgeline::simulate {

std::array<ProjectionMatrix, 2> nominal_pair(const Scene& scene) {
  FlightOptions nominal;
  nominal.attitude_sigma_deg = 0.0;
  nominal.position_sigma_m = 0.0;
  nominal.size_px.fill(
      {2, 2});  // angles are the same in any window; that of a town has too many pixels
  const std::array<AerialView, 2> views = aerial_pair(scene, nominal);
  return {views[0].image_from_world, views[1].image_from_world};
}

io::LineSet classed_by_pair(io::LineSet lines, const std::array<ProjectionMatrix, 2>& pair) {
  for (io::Line& line : lines.lines) {
    line.epipolar_angle_deg =
        epipolar_angle_rad(pair, line.segment_in_world) * 180.0 / std::numbers::pi;
    line.line_class = *line.epipolar_angle_deg <= kMaxAlignedAngle_deg ? "aligned" : "not_aligned";
  }
  return lines;
}

}  // namespace ridgeline::simulate
