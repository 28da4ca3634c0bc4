// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/plan_polygon.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/plane.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// A face of a building model, usually of its roof. Local metres.
struct RoofFace {
  std::string id;
  std::vector<std::vector<Eigen::Vector3d>> rings;  ///< the outer ring, then holes; not closed
  /// The face has no usable plane or area: fewer than three vertices, a coordinate that is not
  /// finite or more than 10,000 km away, a face longer than 10 km, or an area below 1 mm^2. Only id
  /// and rings are set.
  bool degenerate = true;

  Plane3 plane{Eigen::Vector3d::UnitZ(), 0.0};         ///< of the vertices, normal upwards
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the face in plan, on its plane
  double area_m2 = 0.0;                                ///< on its plane, excluding holes
  double flatness_m = 0.0;  ///< largest distance of a vertex from the plane
  PlanPolygon plan;
};

/// A building with its roof faces, which are judged, and its walls and grounds, which explain
/// points.
struct RoofBuilding {
  std::string id;
  std::vector<RoofFace> faces;
  std::vector<RoofFace> others = {};
};

/// Whether a face is so steep that heights on it are meaningless.
inline bool is_upright(const RoofFace& face) {
  constexpr double kUpright_deg = 85.0;
  return slope_rad(face.plane) > kUpright_deg * kRadPerDeg;
}

/// The normal is Newell's normal of the outer ring: the sum of the vertices' cross products, which
/// requires no choice of three vertices; the plane passes through the mean of the ring's vertices.
/// Rings may have either orientation.
RoofFace make_roof_face(std::string id, std::vector<std::vector<Eigen::Vector3d>> rings);

}  // namespace ridgeline::evaluate
