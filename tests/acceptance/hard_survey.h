// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/als.h"
#include "apps/simulate/plan_geometry.h"
#include "apps/simulate/scene.h"
#include "apps/simulate/truth.h"
#include "apps/simulate/village.h"
#include "evaluate/judge/segment_plane.h"
#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"
#include "tests/other_scenes/laser.h"
#include "tests/other_scenes/ray_tracer.h"
#include "tests/other_scenes/settlement.h"
#include "tests/other_scenes/surface_lines.h"
#include "tests/other_scenes/write_scene.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::test {

/// A true line of a scene where other surfaces are beside it or the laser does not see its own.
struct HardLine {
  Segment3 segment{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::string kind;            ///< `ridge`, ..., `foot`, `wall_top`; `object` has no plane
  std::vector<Plane3> planes;  ///< its true surfaces
  std::vector<int> returns;    ///< per plane: laser returns on it within 1.5 m of the line, in plan
  /// The top that a level edge of an object borders: a judge that finds its few points is right,
  /// too.
  std::optional<Plane3> top_of_object;
};

inline std::optional<Plane3> top_of_object(const HardLine& line) {
  constexpr double kLevel_m = 1e-9;
  const bool is_level = std::abs(line.segment.end.z() - line.segment.start.z()) < kLevel_m;
  if (line.kind != "object" || !is_level) return std::nullopt;
  return Plane3(Eigen::Vector3d::UnitZ(), line.segment.start);
}

/// A scene with annexes, dormers, cars, garden walls and feet of walls. No images.
struct HardSurvey {
  std::vector<Eigen::Vector3d> points;  ///< local, without those that read_cloud() drops as noise
  std::vector<HardLine> lines;
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  ///< of the local frame on the map
};

/// `ridgeline simulate` and tests/other_scenes.
enum class Renderer { kVillage, kOther };

/// Every second village falls by 4 degrees in place of 2; every third one has terraces of 1.5 m.
/// Whole runs: `ridgeline simulate --clutter --seed SEED --terrain-slope-deg ... --terrace-step-m
/// ...` makes the same scene, and `other_scene FOLDER SEED VIEWS hard` that of
/// hard_survey_of_other_scene().
inline simulate::VillageOptions hard_village(std::uint64_t seed) {
  simulate::VillageOptions options;
  options.seed = seed;
  set_clutter(options);
  if (seed % 2 == 0) options.terrain_slope_deg = 4.0;
  if (seed % 3 == 0) options.terrace_step_m = 1.5;
  return options;
}

inline HardSurvey survey_of_village(const simulate::VillageOptions& options,
                                    double density_per_m2) {
  constexpr std::uint8_t kLowNoise = 7;
  const simulate::SyntheticScene scene = simulate::make_village(options);
  simulate::AlsOptions als;
  als.seed = 1000 + options.seed;
  als.density_per_m2 = density_per_m2;
  const io::PointCloud cloud = simulate::scan_als(scene, als);
  std::vector<simulate::TruthLine> truth = simulate::observe_lines(scene, cloud);
  HardSurvey survey;
  survey.origin_m = scene.frame.origin_m;
  for (const io::CloudPoint& p : cloud.points) {
    if (p.classification != kLowNoise) survey.points.emplace_back(p.x, p.y, p.z);
  }
  for (std::size_t i = 0; i < scene.lines.size(); ++i) {
    const simulate::SceneLine& line = scene.lines[i];
    HardLine& out = survey.lines.emplace_back();
    out.segment = line.segment;
    out.kind = name(line.kind);
    out.returns = std::move(truth[i].plane_returns);
    out.top_of_object = top_of_object(out);
    for (const int id : line.plane_ids) {
      out.planes.push_back(scene.planes[static_cast<std::size_t>(id)].plane);
    }
  }
  return survey;
}

/// Points on a face within 1.5 m of a line, as observe_lines() counts them. `points` are sorted by
/// x.
inline int returns_near(const std::vector<Eigen::Vector3d>& points,
                        const other::Face& face,
                        const Segment3& line) {
  constexpr double kCorridor_m = 1.5;
  constexpr double kOnPlane_m = 0.15;
  const Plane3 plane(other::normal_of(face), face.corners[0]);
  simulate::ConvexPolygon outline;
  for (const Eigen::Vector3d& corner : face.corners) outline.emplace_back(corner.head<2>());
  if (other::normal_of(face).z() < 0.0) std::reverse(outline.begin(), outline.end());
  const double low_x = std::min(line.start.x(), line.end.x()) - kCorridor_m;
  const double high_x = std::max(line.start.x(), line.end.x()) + kCorridor_m;
  const auto is_left = [](const Eigen::Vector3d& x, double bound) { return x.x() < bound; };
  int count = 0;
  for (auto p = std::lower_bound(points.begin(), points.end(), low_x, is_left);
       p != points.end() && p->x() <= high_x; ++p) {
    const Eigen::Vector2d place = p->head<2>();
    const bool is_near = distance(plan(line), place) <= kCorridor_m &&
                         std::abs(plane.signedDistance(*p)) <= kOnPlane_m;
    if (is_near && simulate::contains(outline, place)) ++count;
  }
  return count;
}

inline HardSurvey hard_survey_of_other_scene(std::uint64_t seed, double density_per_m2) {
  const other::Scene scene = other::make_settlement(seed, true);
  const other::RayTracer tracer(scene);
  HardSurvey survey;
  survey.origin_m = other::scene_origin_m();
  survey.points = other::laser_points(scene, tracer, seed, density_per_m2);
  std::vector<Eigen::Vector3d> sorted = survey.points;
  std::sort(sorted.begin(), sorted.end(),
            [](const auto& a, const auto& b) { return a.x() < b.x(); });
  for (const other::SurfaceLine& line : other::surface_lines(scene, tracer)) {
    HardLine& out = survey.lines.emplace_back();
    out.segment = line.segment;
    out.kind = line.kind;
    out.top_of_object = top_of_object(out);
    for (const int id : line.faces) {
      const other::Face& face = scene.faces[static_cast<std::size_t>(id)];
      out.planes.emplace_back(other::normal_of(face), face.corners[0]);
      out.returns.push_back(returns_near(sorted, face, line.segment));
    }
  }
  return survey;
}

inline HardSurvey hard_survey(std::uint64_t seed,
                              double density_per_m2,
                              Renderer renderer = Renderer::kVillage) {
  return renderer == Renderer::kVillage ? survey_of_village(hard_village(seed), density_per_m2)
                                        : hard_survey_of_other_scene(seed, density_per_m2);
}

/// Mean over the planes of a line of the mean |distance| of a segment to them: what an error-free
/// judge would report. Nothing for an object.
inline std::optional<double> true_mean_distance_m(const HardLine& line, const Segment3& segment) {
  if (line.planes.empty()) return std::nullopt;
  double sum_m = 0.0;
  for (const Plane3& plane : line.planes) sum_m += orthogonal_distance(segment, plane).mean_abs;
  return sum_m / static_cast<double>(line.planes.size());
}

}  // namespace ridgeline::test
