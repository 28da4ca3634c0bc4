// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"

#include <Eigen/Core>

#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::simulate {

/// Ray casting against a mesh; only this class uses Embree. Queries may run in parallel.
class RayScene {
 public:
  struct Ray {
    Eigen::Vector3d origin, direction;  ///< unit vector
    double min_distance_m = 0.0;
  };
  struct Hit {
    double distance_m = 0.0;  ///< along the ray, exact on the triangle's plane
    int triangle = 0;         ///< index into Mesh::triangles
  };

  /// Keeps a reference to the mesh. Throws std::runtime_error if Embree cannot create a device.
  explicit RayScene(const Mesh& mesh);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// The nearest triangle, facing either way, at a distance of at least `min_distance_m` along the
  /// unit vector `direction`.
  [[nodiscard]] std::optional<Hit> first_hit(const Eigen::Vector3d& origin,
                                             const Eigen::Vector3d& direction,
                                             double min_distance_m = 0.0) const;

  /// Whether anything lies between `min_distance_m` and `max_distance_m` along the unit vector
  /// `direction`.
  [[nodiscard]] bool occluded(
      const Eigen::Vector3d& origin,
      const Eigen::Vector3d& direction,
      double min_distance_m = 0.0,
      double max_distance_m = std::numeric_limits<double>::infinity()) const;

  /// first_hit() and occluded() for many rays of similar origin and direction at once, several
  /// times faster. One result per ray. For a ray that passes an edge within single precision, the
  /// result may differ from that of a single query.
  [[nodiscard]] std::vector<std::optional<Hit>> first_hits(std::span<const Ray> rays) const;
  [[nodiscard]] std::vector<char> occluded(std::span<const Ray> rays) const;

 private:
  struct Embree;
  [[nodiscard]] std::optional<Hit> hit_of(const Ray& ray,
                                          unsigned geometry,
                                          unsigned triangle) const;

  const Mesh* mesh_;
  std::unique_ptr<Embree> embree_;
};

}  // namespace ridgeline::simulate
