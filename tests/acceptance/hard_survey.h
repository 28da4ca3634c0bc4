// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/als.h"
#include "apps/simulate/scene.h"
#include "apps/simulate/truth.h"
#include "apps/simulate/village.h"
#include "evaluate/judge/segment_plane.h"
#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::test {

/// A true line of a scene with what hides its surface from the laser or is another one beside it.
struct HardLine {
  Segment3 segment{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::string kind;            ///< `ridge`, ..., `foot`, `wall_top`; `object` has no plane
  std::vector<Plane3> planes;  ///< its true surfaces
  std::vector<int> returns;    ///< per plane: laser returns on it within 1.5 m of the line, in plan
};

/// A scene with annexes, dormers, cars, garden walls and feet of walls. No images.
struct HardSurvey {
  std::vector<Eigen::Vector3d>
      points;  ///< local, without the outliers that read_cloud() drops by their class
  std::vector<HardLine> lines;
};

/// Every second village falls by 4 degrees in place of 2; every third one has terraces of 1.5 m.
inline simulate::VillageOptions hard_village(std::uint64_t seed) {
  simulate::VillageOptions options;
  options.seed = seed;
  set_clutter(options);
  if (seed % 2 == 0) options.terrain_slope_deg = 4.0;
  if (seed % 3 == 0) options.terrace_step_m = 1.5;
  return options;
}

inline HardSurvey hard_survey(std::uint64_t seed, double density_per_m2) {
  constexpr std::uint8_t kLowNoise = 7;
  const simulate::Scene scene = simulate::make_village(hard_village(seed));
  simulate::AlsOptions als;
  als.seed = 1000 + seed;
  als.density_per_m2 = density_per_m2;
  const io::PointCloud cloud = simulate::scan_als(scene, als);
  std::vector<simulate::TruthLine> truth = simulate::observe_lines(scene, cloud);
  HardSurvey survey;
  for (const io::CloudPoint& p : cloud.points) {
    if (p.classification != kLowNoise) survey.points.emplace_back(p.x, p.y, p.z);
  }
  for (std::size_t i = 0; i < scene.lines.size(); ++i) {
    const simulate::SceneLine& line = scene.lines[i];
    HardLine& out = survey.lines.emplace_back();
    out.segment = line.segment;
    out.kind = name(line.kind);
    out.returns = std::move(truth[i].plane_returns);
    for (const int id : line.plane_ids) {
      out.planes.push_back(scene.planes[static_cast<std::size_t>(id)].plane);
    }
  }
  return survey;
}

/// Mean over the planes of a line of the mean |distance| of a segment to them: what an error-free judge would report.
/// Nothing for an object.
inline std::optional<double> true_mean_distance_m(const HardLine& line, const Segment3& segment) {
  if (line.planes.empty()) return std::nullopt;
  double sum_m = 0.0;
  for (const Plane3& plane : line.planes) sum_m += orthogonal_distance(segment, plane).mean_abs;
  return sum_m / static_cast<double>(line.planes.size());
}

}  // namespace ridgeline::test
