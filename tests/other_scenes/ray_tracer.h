// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/other_scenes/scene_model.h"

#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace ridgeline::other {

struct Ray {
  Eigen::Vector3d origin, direction;  ///< any length; distances count in it
};

struct Hit {
  double distance = 0.0;
  int face = -1;       ///< index of the face, or
  int ellipsoid = -1;  ///< of the ellipsoid
};

/// First hits of rays, by a hierarchy of boxes (binary, split at the median of the longest axis).
/// Both sides of faces are hit. The ground, face 0, is without bounds.
class RayTracer {
 public:
  explicit RayTracer(const Scene& scene);

  /// Nothing if the ray meets nothing at a distance between `from` and `to`.
  [[nodiscard]] std::optional<Hit> first_hit(const Ray& ray, double from, double to) const;
  /// Whether the ray meets anything there.
  [[nodiscard]] bool is_blocked(const Ray& ray, double from, double to) const;

 private:
  struct Shape {
    Eigen::Vector3d a, ab, ac;  ///< triangle; or centre and inverse radii
    int face = -1, ellipsoid = -1;
  };
  struct Node {
    Eigen::Vector3d low, high;
    int first = 0;  ///< shape, or the left one of two children beside each other
    int count = 0;  ///< shapes; 0: not a leaf
  };
  struct Inverse {
    Eigen::Vector3d origin, inverse;  ///< of the direction
  };
  struct Boxed;

  void add_triangles(const Scene& scene, std::vector<Boxed>& boxed);
  void build(int node, std::vector<Boxed>& boxed, int from, int to);
  static double distance(const Shape& shape, const Ray& ray, double from, double to);
  /// Where the ray enters a box, if between `from` and `to`.
  static double entry(const Node& node, const Inverse& ray, double from, double to);
  template <bool kAny>
  std::optional<Hit> trace(const Ray& ray, double from, double to) const;

  Eigen::Vector3d ground_point_, ground_normal_;
  std::vector<Shape> shapes_;
  std::vector<Node> nodes_;
};

}  // namespace ridgeline::other
