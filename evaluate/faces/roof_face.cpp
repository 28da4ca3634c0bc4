// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/roof_face.h"

#include "reconstruct/geometry/faces/ring.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ridgeline::evaluate {
namespace {

constexpr double kMaxFaceCoordinate_m = 1e7;  // as in in_range() for lines
constexpr double kMaxFaceExtent_m = 1e4;      // anything larger is an error in the file, not a roof
constexpr double kDegenerateArea_m2 = 1e-6;

bool is_fit(const std::vector<Ring>& rings) {
  if (rings.empty()) return false;
  Eigen::AlignedBox3d box;
  for (const Ring& ring : rings) {
    if (ring.size() < 3) return false;
    for (const Eigen::Vector3d& x : ring) {
      if (!x.allFinite() || x.cwiseAbs().maxCoeff() > kMaxFaceCoordinate_m) return false;
      box.extend(x);
    }
  }
  return box.sizes().maxCoeff() <= kMaxFaceExtent_m;
}

}  // namespace

RoofFace make_roof_face(std::string id, std::vector<Ring> rings) {
  RoofFace face;
  face.id = std::move(id);
  face.rings = std::move(rings);
  if (!is_fit(face.rings)) return face;
  const Ring& outer = face.rings.front();
  const Eigen::Vector3d normal = area_vector(outer);
  face.area_m2 = normal.norm();
  for (std::size_t i = 1; i < face.rings.size(); ++i) {
    face.area_m2 -= area_vector(face.rings[i]).norm();
  }
  if (!(face.area_m2 > kDegenerateArea_m2)) {
    face.area_m2 = 0.0;
    return face;
  }
  face.degenerate = false;
  face.plane = upward(Plane3(normal.normalized(), mean_of(outer)));
  for (const Ring& ring : face.rings) {
    for (const Eigen::Vector3d& x : ring) {
      face.flatness_m = std::max(face.flatness_m, face.plane.absDistance(x));
    }
  }
  face.plan = PlanPolygon(face.rings);
  const bool is_upright = face.plane.normal().z() < 1e-9;
  face.centroid << face.plan.centroid(),
      is_upright ? mean_of(outer).z() : height_at(face.plane, face.plan.centroid());
  return face;
}

}  // namespace ridgeline::evaluate
