// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/solids.h"

#include <array>

namespace ridgeline::other {

using Eigen::Vector3d;

void Solids::add_face(const std::vector<Vector3d>& corners, const Look& look, bool is_roof) {
  Part part{{{}, look}, solid_, is_roof};
  for (const Vector3d& corner : corners) part.face.corners.push_back(local_from_own_ * corner);
  parts_.push_back(std::move(part));
}

void Solids::add_edge(const Vector3d& start, const Vector3d& end, const std::string& kind) {
  edges_.push_back({{local_from_own_ * start, local_from_own_ * end}, kind});
}

void Solids::add_box(const Eigen::AlignedBox3d& box,
                     const Look& walls,
                     const Look& top,
                     const std::string& kind) {
  begin_solid();
  const Vector3d& low = box.min();
  const Vector3d& high = box.max();
  const std::array<Vector3d, 4> foot{low, Vector3d(high.x(), low.y(), low.z()),
                                     Vector3d(high.x(), high.y(), low.z()),
                                     Vector3d(low.x(), high.y(), low.z())};
  const Vector3d up(0.0, 0.0, high.z() - low.z());
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3d& a = foot[i];
    const Vector3d& b = foot[(i + 1) % 4];
    add_face({a, b, b + up, a + up}, walls);
    add_edge(a + up, b + up, kind);
    add_edge(a, a + up, kind);
  }
  add_face({foot[0] + up, foot[1] + up, foot[2] + up, foot[3] + up}, top);
}

void Solids::finish(Scene& scene, const std::string& kind) const {
  const auto add = [&](const Segment3& segment, const std::string& of_kind) {
    if (length(segment) > 0.1) scene.edges.push_back({segment, of_kind});
  };
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (parts_[i].solid == parts_[j].solid) continue;
      const bool is_valley = parts_[i].is_roof && parts_[j].is_roof;
      add(common_segment(parts_[i].face, parts_[j].face), is_valley ? "valley" : kind);
    }
    add(common_segment(scene.faces.front(), parts_[i].face), kind);
    scene.faces.push_back(parts_[i].face);
  }
  for (const Edge& edge : edges_) add(edge.segment, edge.kind);
}

Eigen::Isometry3d standing_at(const Scene& scene,
                              const Eigen::Vector2d& place,
                              const Eigen::Vector2d& along) {
  Eigen::Isometry3d local_from_own = Eigen::Isometry3d::Identity();
  local_from_own.linear().col(0) << along, 0.0;
  local_from_own.linear().col(1) << -along.y(), along.x(), 0.0;
  local_from_own.translation() = scene.on_ground(place);
  return local_from_own;
}

}  // namespace ridgeline::other
