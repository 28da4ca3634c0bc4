// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace ridgeline::simulate {

/// Reflectance (0..1) or radiance in red, green, blue and near infrared.
using Spectrum = Eigen::Array4f;

/// The appearance of the surfaces of a scene. It depends only on the surface point and a seed, so
/// that all views agree, and has no detail below the given footprint.
class Appearance {
 public:
  /// Keeps a reference to the scene. `texture`: contrast of the textures, 0: flat colours.
  Appearance(const SyntheticScene& scene, std::uint32_t seed, float texture);

  /// Reflectance at a point of a triangle of the mesh, for samples that are `footprint_m` apart.
  [[nodiscard]] Spectrum reflectance(int triangle,
                                     const Eigen::Vector3d& x_in_local,
                                     float footprint_m) const;

  /// Colour of the ground beyond the mesh.
  [[nodiscard]] Spectrum lawn(const Eigen::Vector3d& x_in_local, float footprint_m) const;

  /// Outward unit normal for shading: the triangle's normal, which for a leaf is bent towards the
  /// normal of its crown.
  [[nodiscard]] const Eigen::Vector3f& normal(int triangle) const {
    return surfaces_[static_cast<std::size_t>(triangle)].normal;
  }

 private:
  struct TriangleSurface {
    Eigen::Vector3f normal;
    Eigen::Vector3f u_axis;      ///< horizontal direction
    Eigen::Vector3f v_axis;      ///< direction up the slope
    std::uint32_t key = 0;       ///< key of the colour: one per building, car or tree
    std::uint32_t face_key = 0;  ///< key of the texture: one per plane or triangle
    Spectrum base = Spectrum::Zero();
    bool tiled = false;
  };

  [[nodiscard]] Spectrum textured(int triangle,
                                  const Eigen::Vector3d& x_in_local,
                                  float footprint_m) const;
  [[nodiscard]] TriangleSurface surface_of(const Triangle& triangle, std::uint32_t index) const;
  void bend_leaves();

  const SyntheticScene* scene_;
  std::uint32_t seed_;
  float texture_;
  std::vector<TriangleSurface> surfaces_;  ///< one per triangle
};

}  // namespace ridgeline::simulate
