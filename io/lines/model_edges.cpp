// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/model_edges.h"

#include "io/models/face_geometry.h"
#include "io/models/face_seams.h"
#include "io/models/settle_model.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/roof_edge.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace ridgeline::io {
namespace {

constexpr Kind kCrowdedEdge{"edge of three roof faces or more",
                            "edges of three roof faces or more"};

/// The edges of the roofs of one building.
class EdgesOfBuilding {
 public:
  EdgesOfBuilding(std::span<const ModelFace> faces, const ModelEdgeOptions& options)
      : faces_(faces),
        planes_(transformed(faces, [](const ModelFace& face) { return *plane_of(face); })),
        options_(options) {}

  void append(const Line& attributes, std::size_t first_face, LineSet& set) {
    std::size_t number = 0;
    for (const FaceSeam& seam : seams_of(faces_)) {
      const std::vector<std::size_t> roofs = with_kind(seam, SurfaceKind::kRoof);
      if (roofs.size() > 2) set.left_out.add(kCrowdedEdge);
      const std::string kind = kind_of(seam, roofs);
      if (kind.empty()) continue;
      Line line = attributes;
      line.id = fmt::format("{}.{}", attributes.building, number++);
      line.kind = kind;
      line.segment_in_world = seam.segment;
      for (const std::size_t face : roofs)
        line.plane_ids.push_back(static_cast<int>(first_face + face));
      set.lines.push_back(std::move(line));
    }
  }

 private:
  [[nodiscard]] std::vector<std::size_t> with_kind(const FaceSeam& seam, SurfaceKind kind) const {
    std::vector<std::size_t> found = seam.faces;
    std::erase_if(found, [&](std::size_t face) { return faces_[face].kind != kind; });
    return found;
  }

  /// Empty for an edge that is no line.
  [[nodiscard]] std::string kind_of(const FaceSeam& seam,
                                    const std::vector<std::size_t>& roofs) const {
    if (roofs.size() == 1) return kind_of_border_of(seam, roofs[0]);
    return roofs.size() == 2 ? kind_of_fold(seam.segment, roofs[0], roofs[1]) : "";
  }

  [[nodiscard]] std::string kind_of_border_of(const FaceSeam& seam, std::size_t roof) const {
    const auto rises = [&](std::size_t wall) {
      const auto way = inward(wall, seam.segment);
      return way && way->z() > 0.0;
    };
    const bool is_foot = std::ranges::any_of(with_kind(seam, SurfaceKind::kWall), rises);
    return is_foot ? "step" : kind_of_border(upward(planes_[roof]), seam.segment);
  }

  /// The edge of two roof faces; empty if they are nearly coplanar.
  [[nodiscard]] std::string kind_of_fold(const Segment3& edge, std::size_t a, std::size_t b) const {
    const Eigen::Vector3d normal_a = upward(planes_[a]).normal();
    const Eigen::Vector3d normal_b = upward(planes_[b]).normal();
    if (acute_angle_rad(normal_a, normal_b) < options_.least_angle_deg * kRadPerDeg) return "";
    const auto inward_a = inward(a, edge), inward_b = inward(b, edge);
    const double above =
        (inward_a ? normal_b.dot(*inward_a) : 0.0) + (inward_b ? normal_a.dot(*inward_b) : 0.0);
    if (above > 0.0) return "valley";
    return is_level(edge) ? "ridge" : "hip";
  }

  [[nodiscard]] std::optional<Eigen::Vector3d> inward(std::size_t face,
                                                      const Segment3& edge) const {
    return inward_of(faces_[face], planes_[face], edge);
  }

  std::span<const ModelFace> faces_;
  std::vector<Plane3> planes_;
  const ModelEdgeOptions& options_;
};

}  // namespace

LineSet lines_of_model(BuildingModel model, const ModelEdgeOptions& options) {
  settle(model);
  LineSet set;
  set.path = model.path;
  set.format = model.format + ", edges of roofs";
  set.crs = model.crs;
  set.features = std::exchange(model.attributes, {});
  set.left_out = model.left_out;
  set.warnings = model.warnings;
  std::size_t first_face = 0;
  for_each_building(model, [&](std::size_t building, std::span<const ModelFace> faces) {
    Line attributes;
    attributes.building = model.buildings[building].id;
    attributes.row = building;
    attributes.source_fid = static_cast<std::int64_t>(building);
    EdgesOfBuilding(faces, options).append(attributes, first_face, set);
    first_face += faces.size();
  });
  set.model = std::make_shared<const BuildingModel>(std::move(model));
  return set;
}

}  // namespace ridgeline::io
