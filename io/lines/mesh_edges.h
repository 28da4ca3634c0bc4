// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"
#include "io/lines/mesh_buildings.h"
#include "io/lines/polyline.h"

#include <cstddef>
#include <vector>

namespace ridgeline::io {

/// Indices, from 0, of the vertices of a polygon or a polyline.
using IndexList = std::vector<std::size_t>;

/// A mesh of closed polygons.
struct PolygonMesh {
  Vertices vertices;
  std::vector<IndexList> polygons;
  MeshNames names;  ///< of the polygons
};

/// Adds the edges of a mesh. If it has walls (faces steeper than 80 degrees), it is a building
/// model, whose lines are the edges of its roofs (lines_of_model()), with buildings as in
/// divide_into_buildings(). For any other mesh, each distinct edge is added once, in order of first
/// occurrence. Edges are the same if their end points have equal
/// coordinates, in either direction: many models repeat the vertices for each face. Edges of zero
/// length are left out because they bound nothing.
void append_mesh(const PolygonMesh& mesh, LineSet& set);

}  // namespace ridgeline::io
