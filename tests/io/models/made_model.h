// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/models/building_model.h"
#include "tests/support/made_buildings.h"

#include <Eigen/Core>

#include <span>
#include <string>

namespace ridgeline::io {

/// Where made buildings stand in the world.
inline const Eigen::Vector3d kMadeOrigin{513000.0, 5403000.0, 250.0};

/// Made buildings "1", "2", ... as a model whose file states what faces are, or not.
inline BuildingModel model_of(std::span<const test::MadeBuilding> buildings, bool states_kinds) {
  BuildingModel model;
  model.path = "made";
  model.format = "made";
  for (const test::MadeBuilding& made : buildings) {
    const std::size_t number = model.buildings.size();
    model.buildings.push_back({std::to_string(number + 1), "2"});
    model.attributes.rows.emplace_back();
    for (const test::MadeFace& made_face : made.faces) {
      Face face;
      face.building = number;
      if (states_kinds) {
        face.kind = made_face.kind == test::MadeSurface::kRoof   ? FaceKind::kRoof
                    : made_face.kind == test::MadeSurface::kWall ? FaceKind::kWall
                                                                 : FaceKind::kGround;
      }
      for (Ring ring : made_face.rings) {
        for (Eigen::Vector3d& x : ring) x += kMadeOrigin;
        face.rings.push_back(std::move(ring));
      }
      model.faces.push_back(std::move(face));
    }
  }
  return model;
}

}  // namespace ridgeline::io
