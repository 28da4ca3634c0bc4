// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/made_buildings.h"

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"
#include "tests/support/made_shell.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace ridgeline::test {
namespace {

void place(std::vector<MadeFace>& faces, const BuildingSpec& spec) {
  const Eigen::Isometry3d local_from_own =
      Eigen::Translation3d(spec.position) *
      Eigen::AngleAxisd(spec.azimuth_deg * kRadPerDeg, Eigen::Vector3d::UnitZ());
  for (MadeFace& face : faces) {
    for (MadeRing& ring : face.rings) {
      for (Eigen::Vector3d& x : ring) x = local_from_own * x;
    }
  }
}

/// Halves the first roof face of four corners from the middle of its first edge to that of its
/// third. The second half comes behind the other roof faces.
void split_a_roof_face(std::vector<MadeFace>& faces) {
  const auto is_roof = [](const MadeFace& face) { return face.kind == MadeSurface::kRoof; };
  const auto whole = std::ranges::find_if(faces, [&](const MadeFace& face) {
    return is_roof(face) && face.rings.size() == 1 && face.rings[0].size() == 4;
  });
  check(whole != faces.end(),
        "make_building: no roof face of this shape has four corners to be split");
  const MadeRing ring = whole->rings[0];
  const Eigen::Vector3d low = 0.5 * (ring[0] + ring[1]);
  const Eigen::Vector3d high = 0.5 * (ring[2] + ring[3]);
  whole->rings[0] = {ring[0], low, high, ring[3]};
  const MadeFace other{MadeSurface::kRoof, {{low, ring[1], ring[2], high}}};
  faces.insert(std::ranges::find_if_not(faces, is_roof), other);
}

}  // namespace

MadeBuilding make_building(const BuildingSpec& spec) {
  std::vector<MadeFace> faces = shell_of(spec).faces;
  place(faces, spec);
  std::stable_partition(faces.begin(), faces.end(),
                        [](const MadeFace& face) { return face.kind == MadeSurface::kRoof; });
  MadeBuilding building{spec, std::move(faces), {}};
  building.edges = roof_edges(building.faces);
  if (spec.t_junctions) split_a_roof_face(building.faces);
  return building;
}

}  // namespace ridgeline::test
