// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/plan_polygon.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/plane.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// A face of a building model, most of all of its roof. Local metres.
struct RoofFace {
  std::string id;
  std::vector<std::vector<Eigen::Vector3d>> rings;  ///< the outer one, then holes; not closed
  /// Neither a plane nor an area: fewer than three vertices, a coordinate that is not finite or
  /// more than 10,000 km off, a face longer than 10 km, or an area below 1 mm^2. Only id and rings
  /// are set.
  bool degenerate = true;

  Plane3 plane{Eigen::Vector3d::UnitZ(), 0.0};         ///< of the vertices, normal upwards
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the face in plan, on its plane
  double area_m2 = 0.0;                                ///< on its plane, without holes
  double flatness_m = 0.0;  ///< largest distance of a vertex from the plane
  PlanPolygon plan;
};

/// A building by its roof faces, which are judged, and its walls and grounds, which explain points.
struct RoofBuilding {
  std::string id;
  std::vector<RoofFace> faces;
  std::vector<RoofFace> others = {};
};

/// Whether a face is so steep that heights over it mean nothing.
inline bool is_upright(const RoofFace& face) {
  constexpr double kUpright_deg = 85.0;
  return slope_rad(face.plane) > kUpright_deg * kRadPerDeg;
}

/// The normal is Newell's, of the outer ring: the sum of the vertices' cross products, which needs
/// no choice of three vertices; the plane goes through the mean of the ring's vertices. Rings may
/// run either way round.
RoofFace make_roof_face(std::string id, std::vector<std::vector<Eigen::Vector3d>> rings);

}  // namespace ridgeline::evaluate
