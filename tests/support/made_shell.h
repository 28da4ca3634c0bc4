// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/support/made_buildings.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace ridgeline::test {

using MadeRing = std::vector<Eigen::Vector3d>;

/// The faces of a building under construction.
struct MadeShell {
  std::vector<MadeFace> faces;

  void roof(MadeRing ring) { add(MadeSurface::kRoof, {std::move(ring)}); }
  void roof(MadeRing ring, MadeRing hole) {
    add(MadeSurface::kRoof, {std::move(ring), std::move(hole)});
  }
  void wall(MadeRing ring) { add(MadeSurface::kWall, {std::move(ring)}); }
  /// Adds the face that closes a building from below; `ring` is counter-clockwise from above.
  void ground(MadeRing ring) { add(MadeSurface::kGround, {MadeRing(ring.rbegin(), ring.rend())}); }
  /// Adds walls from the border of the faces down to z = 0, and the ground between them; the border
  /// must be a single ring that is a simple polygon in plan. Edges on one line in plan, such as the
  /// verges of a gable, share one wall.
  void close_to_ground();

 private:
  void add(MadeSurface kind, std::vector<MadeRing> rings) {
    faces.push_back({kind, std::move(rings)});
  }
  [[nodiscard]] MadeRing border() const;
};

/// The faces of a shape in its own frame, with the base at z = 0.
MadeShell shell_of(const BuildingSpec& spec);

}  // namespace ridgeline::test
