// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/scene.h"

#include "evaluate/judge/segment_plane.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <utility>

namespace ridgeline::simulate {

const char* name(LineKind kind) {
  switch (kind) {
    case LineKind::kRidge:
      return "ridge";
    case LineKind::kHip:
      return "hip";
    case LineKind::kValley:
      return "valley";
    case LineKind::kEave:
      return "eave";
    case LineKind::kVerge:
      return "verge";
    case LineKind::kGround:
      return "ground";
    case LineKind::kJoint:
      return "joint";
    case LineKind::kFoot:
      return "foot";
    case LineKind::kWallTop:
      return "wall_top";
    case LineKind::kObject:
      return "object";
  }
  return "";
}

const char* name(RoofType type) {
  switch (type) {
    case RoofType::kGabled:
      return "gabled";
    case RoofType::kHipped:
      return "hipped";
    case RoofType::kFlat:
      return "flat";
    case RoofType::kParapet:
      return "parapet";
    case RoofType::kShed:
      return "shed";
    case RoofType::kLShaped:
      return "l_shaped";
    case RoofType::kGabledDormers:
      return "gabled_dormers";
    case RoofType::kShedDormers:
      return "shed_dormers";
    case RoofType::kRow:
      return "row";
  }
  return "";
}

Eigen::Vector3d triangle_normal(const Mesh& mesh, int triangle) {
  const auto& ids = mesh.triangles[static_cast<std::size_t>(triangle)].vertices;
  const Eigen::Vector3d& a = mesh.vertices[static_cast<std::size_t>(ids[0])];
  const Eigen::Vector3d& b = mesh.vertices[static_cast<std::size_t>(ids[1])];
  const Eigen::Vector3d& c = mesh.vertices[static_cast<std::size_t>(ids[2])];
  return (b - a).cross(c - a).normalized();
}

io::LineSet true_lines(const SyntheticScene& scene) {
  io::LineSet set;
  set.format = "simulated";
  set.crs = scene.crs;
  set.lines.reserve(scene.lines.size());
  for (const SceneLine& line : scene.lines) {
    io::Line out;
    out.id = std::to_string(set.lines.size());
    out.segment_in_world = {scene.frame.world_from_local(line.segment.start),
                            scene.frame.world_from_local(line.segment.end)};
    out.kind = name(line.kind);
    if (line.building_id != kNone) out.building = std::to_string(line.building_id);
    out.plane_ids = line.plane_ids;
    set.lines.push_back(std::move(out));
  }
  return set;
}

io::BuildingModel true_model(const SyntheticScene& scene) {
  io::BuildingModel model;
  model.format = "simulated";
  model.crs = scene.crs;
  model.attributes.columns = {{"building", io::ColumnType::kInteger64},
                              {"roof", io::ColumnType::kText},
                              {"pitch_deg", io::ColumnType::kReal},
                              {"ridge_azimuth_deg", io::ColumnType::kReal}};
  for (const SceneBuilding& building : scene.buildings) {
    model.buildings.push_back({fmt::format("building_{}", building.id), "2"});
    model.attributes.rows.push_back({{0, std::int64_t{building.id}},
                                     {1, std::string(name(building.type))},
                                     {2, building.pitch_rad / kRadPerDeg},
                                     {3, building.ridge_azimuth_rad / kRadPerDeg}});
  }
  for (const Face& face : scene.faces) {
    Face& in_world = model.faces.emplace_back(face);
    for (Ring& ring : in_world.rings) {
      for (Eigen::Vector3d& x : ring) x = scene.frame.world_from_local(x);
    }
  }
  return model;
}

double true_mean_distance(const SyntheticScene& scene, const Segment3& segment, int line_id) {
  check(line_id >= 0 && line_id < static_cast<int>(scene.lines.size()),
        "true_mean_distance: line_id = ", line_id, ", must be the number of a true line");
  const std::vector<int>& planes = scene.lines[static_cast<std::size_t>(line_id)].plane_ids;
  check(!planes.empty(), "true_mean_distance: line_id = ", line_id,
        ", must be the number of a line that lies on a plane");
  double sum = 0.0;
  for (const int id : planes) {
    const Plane3& plane = scene.planes[static_cast<std::size_t>(id)].plane;
    sum += orthogonal_distance(segment, plane).mean_abs;
  }
  return sum / static_cast<double>(planes.size());
}

}  // namespace ridgeline::simulate
