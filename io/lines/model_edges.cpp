// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/model_edges.h"

#include "io/models/settle_model.h"
#include "reconstruct/geometry/faces/face_edges.h"

#include <fmt/format.h>

#include <memory>
#include <span>
#include <utility>

namespace ridgeline::io {
namespace {

constexpr LeftOutKind kCrowdedEdge{"edge of three roof faces or more",
                                   "edges of three roof faces or more"};

/// Appends the edges of the roofs of a building.
void append_edges(std::span<const Face> faces,
                  const Line& attributes,
                  std::size_t first_face,
                  LineSet& set) {
  const FaceEdges found = edges_of_roofs(faces);
  if (found.n_crowded > 0) set.left_out.add(kCrowdedEdge, found.n_crowded);
  std::size_t number = 0;
  for (const FaceEdge& edge : found.edges) {
    Line line = attributes;
    line.id = fmt::format("{}.{}", attributes.building, number++);
    line.kind = edge.kind;
    line.segment_in_world = edge.segment;
    for (const std::size_t face : edge.roofs)
      line.plane_ids.push_back(static_cast<int>(first_face + face));
    set.lines.push_back(std::move(line));
  }
}

}  // namespace

LineSet lines_of_model(BuildingModel model) {
  settle(model);
  LineSet set;
  set.path = model.path;
  set.format = model.format + ", edges of roofs";
  set.crs = model.crs;
  set.features = std::exchange(model.attributes, {});
  set.left_out = model.left_out;
  set.warnings = model.warnings;
  std::size_t first_face = 0;
  for_each_building(model, [&](std::size_t building, std::span<const Face> faces) {
    Line attributes;
    attributes.building = model.buildings[building].id;
    attributes.row = building;
    attributes.source_fid = static_cast<std::int64_t>(building);
    append_edges(faces, attributes, first_face, set);
    first_face += faces.size();
  });
  set.model = std::make_shared<const BuildingModel>(std::move(model));
  return set;
}

}  // namespace ridgeline::io
