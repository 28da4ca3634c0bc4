// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/scene_model.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace ridgeline::other {

/// Solids that stand together (a house with what is on it and beside it), made in a frame of their
/// own: x along, y across, z up from the floor. They may cut into each other: rays see the
/// outermost.
class Solids {
 public:
  explicit Solids(Eigen::Isometry3d local_from_own) : local_from_own_(std::move(local_from_own)) {}

  /// Faces that follow belong to a new solid.
  void begin_solid() { ++solid_; }
  /// `corners` in the own frame; see Face.
  void add_face(const std::vector<Eigen::Vector3d>& corners,
                const Look& look,
                bool is_roof = false);
  void add_edge(const Eigen::Vector3d& start, const Eigen::Vector3d& end, const std::string& kind);
  /// A new solid: an upright box with its edges, and a roof of its own look.
  void add_box(const Eigen::AlignedBox3d& box,
               const Look& walls,
               const Look& top,
               const std::string& kind);

  /// Puts all into the scene, with the edges where faces of different solids, or a solid and the
  /// ground, meet: a valley where two roofs do, else of `kind`.
  void finish(Scene& scene, const std::string& kind) const;

 private:
  struct Part {
    Face face;
    int solid = 0;
    bool is_roof = false;
  };

  Eigen::Isometry3d local_from_own_;
  int solid_ = 0;
  std::vector<Part> parts_;
  std::vector<Edge> edges_;
};

/// The frame of something that stands on the ground at `place`, its x axis towards `along` (unit).
Eigen::Isometry3d standing_at(const Scene& scene,
                              const Eigen::Vector2d& place,
                              const Eigen::Vector2d& along);

}  // namespace ridgeline::other
