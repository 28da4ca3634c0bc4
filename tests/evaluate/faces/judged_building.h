// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/judge_faces.h"
#include "evaluate/judge/point_grid.h"
#include "reconstruct/geometry/degrees.h"
#include "tests/support/made_buildings.h"
#include "tests/support/made_points.h"
#include "tests/support/random.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace ridgeline::test {

using Rings = std::vector<std::vector<Eigen::Vector3d>>;

/// The roof faces of a made building, named by their place.
inline evaluate::RoofBuilding roof_of(const MadeBuilding& made, const std::string& id = "b") {
  evaluate::RoofBuilding building{id, {}};
  for (const MadeFace& face : made.faces) {
    if (face.kind != MadeSurface::kRoof) continue;
    building.faces.push_back(
        evaluate::make_roof_face(std::to_string(building.faces.size()), face.rings));
  }
  return building;
}

inline evaluate::PointGrid grid_of(const std::vector<Eigen::Vector3d>& points) {
  return evaluate::PointGrid::build(points.size(), [&](std::size_t i) { return points[i]; });
}

inline evaluate::PointGrid scan_of(const MadeBuilding& made, const ScanSpec& spec) {
  return grid_of(scan(std::span(&made, 1), spec));
}

inline evaluate::RoofFace transformed(const evaluate::RoofFace& face,
                                      const Eigen::Isometry3d& b_from_a) {
  Rings rings = face.rings;
  for (auto& ring : rings) {
    for (Eigen::Vector3d& x : ring) x = b_from_a * x;
  }
  return evaluate::make_roof_face(face.id, rings);
}

/// How a face is made wrong: steeper by `pitch_deg` and clockwise from above by `aspect_deg` about
/// its centroid, then raised by `shift_m` along the normal that it has now. An edge `edge` of the
/// outer ring is moved outwards within the plane by `outwards_m`.
struct Fault {
  double shift_m = 0.0, pitch_deg = 0.0, aspect_deg = 0.0;
  std::size_t edge = 0;
  double outwards_m = 0.0;
};

inline evaluate::RoofFace with_edge_moved(const evaluate::RoofFace& face,
                                          std::size_t edge,
                                          double outwards_m) {
  Rings rings = face.rings;
  std::vector<Eigen::Vector3d>& ring = rings[0];
  Eigen::Vector3d& a = ring[edge];
  Eigen::Vector3d& b = ring[(edge + 1) % ring.size()];
  const Eigen::Vector3d along = (b - a).normalized();
  // the ring runs counter-clockwise, so that the face lies to the left of the edge
  const Eigen::Vector3d out = along.cross(face.plane.normal());
  a += outwards_m * out;
  b += outwards_m * out;
  return evaluate::make_roof_face(face.id, rings);
}

inline evaluate::RoofFace with_fault(const evaluate::RoofFace& face, const Fault& fault) {
  const Eigen::Vector3d fall(face.plane.normal().x(), face.plane.normal().y(), 0.0);
  // about the level axis to the left of the fall, the normal sinks further towards the fall
  const Eigen::Vector3d level = fall.norm() > 0.0
                                    ? Eigen::Vector3d(-fall.y(), fall.x(), 0.0).normalized()
                                    : Eigen::Vector3d::UnitX();
  const Eigen::Isometry3d turned =
      Eigen::Translation3d(face.centroid) *
      Eigen::AngleAxisd(-fault.aspect_deg * kRadPerDeg, Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(fault.pitch_deg * kRadPerDeg, level) * Eigen::Translation3d(-face.centroid);
  evaluate::RoofFace wrong = transformed(face, turned);
  const Eigen::Vector3d raise = fault.shift_m * wrong.plane.normal();
  wrong = transformed(wrong, Eigen::Isometry3d(Eigen::Translation3d(raise)));
  return with_edge_moved(wrong, fault.edge, fault.outwards_m);
}

/// The face over the same outline in plan, raised by `height_m` and steeper by `pitch_deg` about
/// the middle of its first edge: a model with the right ground plan.
inline evaluate::RoofFace with_height(const evaluate::RoofFace& face,
                                      double height_m,
                                      double pitch_deg) {
  const Eigen::Vector2d fall = face.plane.normal().head<2>().normalized();
  const double slope_rad = ridgeline::slope_rad(face.plane);
  const double more = std::tan(slope_rad + pitch_deg * kRadPerDeg) - std::tan(slope_rad);
  Rings rings = face.rings;
  const Eigen::Vector2d pivot = 0.5 * (rings[0][0] + rings[0][1]).head<2>();
  for (auto& ring : rings) {
    for (Eigen::Vector3d& x : ring) x.z() += height_m - more * fall.dot(x.head<2>() - pivot);
  }
  return evaluate::make_roof_face(face.id, rings);
}

/// A gabled house of random pitch, direction and shape whose two faces have this area.
inline BuildingSpec random_gable(double area_m2, Random& random) {
  const double pitch_deg = random.uniform(15.0, 50.0);
  const double half_width_m = std::sqrt(area_m2 * random.uniform(0.5, 1.0));  // along the slope
  return {.length_m = area_m2 / half_width_m,
          .width_m = 2.0 * half_width_m * std::cos(pitch_deg * kRadPerDeg),
          .eave_height_m = random.uniform(3.0, 8.0),
          .pitch_deg = pitch_deg,
          .azimuth_deg = random.uniform(0.0, 360.0),
          .position = random.vector(-100.0, 100.0)};
}

/// The evaluation of the first face of a made building, which `change` makes another one.
template <typename Change>
evaluate::FaceEvaluation judged_after(const BuildingSpec& spec,
                                      const Change& change,
                                      const ScanSpec& scan_spec) {
  const MadeBuilding made = make_building(spec);
  evaluate::RoofBuilding building = roof_of(made);
  building.faces[0] = change(building.faces[0]);
  return evaluate::judge_faces(scan_of(made, scan_spec), std::span(&building, 1), {})[0][0];
}

}  // namespace ridgeline::test
