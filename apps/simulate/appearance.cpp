// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/appearance.h"

#include "apps/simulate/noise.h"
#include "apps/simulate/palette.h"

#include <Eigen/Geometry>

#include <map>

namespace ridgeline::simulate {
namespace {

constexpr float kLevelCosine = 0.9999F;  // roofs level to within 0.8 degrees are treated as flat

/// Brightness of a tiled roof: courses run across the slope and columns along it, tiles differ
/// slightly, and old roofs have stains and moss.
float tile_factor(const Eigen::Vector2f& uv_m, float footprint_m, std::uint32_t key) {
  constexpr float kTwoPi = 6.2831853F;
  const float course_m = 0.30F + 0.08F * unit(hash(key, 1U));
  const float column_m = 0.20F + 0.10F * unit(hash(key, 2U));
  const float depth = 0.05F + 0.12F * unit(hash(key, 3U));
  const float course = uv_m.y() / course_m;
  const float column = uv_m.x() / column_m;
  const auto seen = [&](float period_m) { return footprint_m < 0.5F * period_m ? 1.0F : 0.0F; };
  // the lower edge of a course casts a narrow shadow: fundamental and second harmonic
  float factor = 1.0F + depth * seen(course_m) * std::cos(kTwoPi * course) +
                 0.5F * depth * seen(0.5F * course_m) * std::cos(2.0F * kTwoPi * course);
  factor += 0.6F * depth * seen(column_m) * std::cos(kTwoPi * column);
  const std::uint32_t tile = hash(static_cast<std::int32_t>(std::floor(column)),
                                  static_cast<std::int32_t>(std::floor(course)), key);
  factor += seen(column_m) * 0.10F * (unit(tile) - 0.5F);
  factor += 0.10F * fractal_noise(uv_m, 6.0F, std::max(0.2F, 2.0F * footprint_m), 0.6F, key);
  return factor;
}

Spectrum lawn_reflectance(const Eigen::Vector2f& x_m, float footprint_m, std::uint32_t key) {
  const float shortest_m = std::max(0.08F, 2.0F * footprint_m);
  const float dry = fractal_noise(x_m, 9.0F, 0.8F, 0.6F, key);
  const float blades = fractal_noise(x_m, 0.5F, shortest_m, 0.8F, hash(key));
  const Spectrum green = base_reflectance(Material::kGround, false, key);
  const Spectrum straw(0.22F, 0.20F, 0.11F, 0.36F);
  const float usual = 0.1F + 0.4F * unit(hash(key, 5U));  // each garden is maintained differently
  const float share = std::clamp(usual + 0.9F * dry, 0.0F, 1.0F);
  return (green + share * (straw - green)) * (1.0F + 0.35F * blades);
}

}  // namespace

Appearance::Appearance(const SyntheticScene& scene, std::uint32_t seed, float texture)
    : scene_(&scene), seed_(seed), texture_(texture) {
  surfaces_.reserve(scene.mesh.triangles.size());
  for (const Triangle& triangle : scene.mesh.triangles) {
    surfaces_.push_back(surface_of(triangle, static_cast<std::uint32_t>(surfaces_.size())));
  }
  bend_leaves();
}

Appearance::TriangleSurface Appearance::surface_of(const Triangle& triangle,
                                                   std::uint32_t index) const {
  TriangleSurface surface;
  surface.normal = triangle_normal(scene_->mesh, static_cast<int>(index)).cast<float>();
  const bool level = std::abs(surface.normal.z()) > kLevelCosine;
  Eigen::Vector3f along = Eigen::Vector3f::UnitX();
  if (!level) {
    along = Eigen::Vector3f::UnitZ().cross(surface.normal).normalized();
  } else if (triangle.building_id != kNone) {
    const double azimuth =
        scene_->buildings[static_cast<std::size_t>(triangle.building_id)].ridge_azimuth_rad;
    along = Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0.0).cast<float>();
  }
  surface.u_axis = along;
  surface.v_axis = surface.normal.cross(along);
  const int object = triangle.building_id != kNone ? triangle.building_id : triangle.object_id;
  surface.key = hash(static_cast<std::uint32_t>(object), seed_);
  surface.face_key = hash(
      triangle.plane_id != kNone ? static_cast<std::uint32_t>(triangle.plane_id) : ~index, seed_);
  surface.base = base_reflectance(triangle.material, level, surface.key);
  surface.tiled = triangle.material == Material::kRoof && !level;
  return surface;
}

/// Bends the normals of leaves towards the normal of their crown. With individual normals, the
/// leaves would glitter.
void Appearance::bend_leaves() {
  const Mesh& mesh = scene_->mesh;
  struct Crown {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double count = 0.0;
  };
  std::map<int, Crown> crowns;
  for (const Triangle& triangle : mesh.triangles) {
    if (triangle.material != Material::kFoliage) continue;
    Crown& crown = crowns[triangle.object_id];
    crown.sum += mesh.vertices[static_cast<std::size_t>(triangle.vertices[0])];
    crown.count += 1.0;
  }
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const Triangle& triangle = mesh.triangles[i];
    if (triangle.material != Material::kFoliage) continue;
    const Crown& crown = crowns[triangle.object_id];
    const Eigen::Vector3d outwards =
        mesh.vertices[static_cast<std::size_t>(triangle.vertices[0])] - crown.sum / crown.count;
    TriangleSurface& leaf = surfaces_[i];
    if (leaf.normal.z() < 0.0F) leaf.normal = -leaf.normal;
    leaf.normal = (0.4F * leaf.normal + outwards.normalized().cast<float>()).normalized();
    leaf.base *= 0.7F + 0.6F * unit(leaf.face_key);
  }
}

Spectrum Appearance::lawn(const Eigen::Vector3d& x_in_local, float footprint_m) const {
  const Spectrum flat = base_reflectance(Material::kGround, false, seed_);
  const Eigen::Vector2f x_m = x_in_local.head<2>().cast<float>();
  return flat + texture_ * (lawn_reflectance(x_m, footprint_m, seed_) - flat);
}

Spectrum Appearance::reflectance(int triangle,
                                 const Eigen::Vector3d& x_in_local,
                                 float footprint_m) const {
  const Spectrum& flat = surfaces_[static_cast<std::size_t>(triangle)].base;
  if (texture_ == 0.0F) return flat;
  return (flat + texture_ * (textured(triangle, x_in_local, footprint_m) - flat)).max(0.0F);
}

Spectrum Appearance::textured(int triangle,
                              const Eigen::Vector3d& x_in_local,
                              float footprint_m) const {
  const TriangleSurface& surface = surfaces_[static_cast<std::size_t>(triangle)];
  const Eigen::Vector3f x = x_in_local.cast<float>();
  const Eigen::Vector2f uv(surface.u_axis.dot(x), surface.v_axis.dot(x));
  const float shortest_m = std::max(0.08F, 2.0F * footprint_m);
  switch (scene_->mesh.triangles[static_cast<std::size_t>(triangle)].material) {
    case Material::kGround:
      return lawn_reflectance(x.head<2>(), footprint_m, surface.key);
    case Material::kStreet:
      return surface.base *
             (1.0F + 0.22F * fractal_noise(x.head<2>(), 5.0F, shortest_m, 0.7F, seed_));
    case Material::kMarking:
      return surface.base *
             (1.0F + 0.25F * fractal_noise(x.head<2>(), 0.8F, shortest_m, 0.8F, seed_));
    case Material::kRoof:
      if (surface.tiled) return surface.base * tile_factor(uv, footprint_m, surface.key);
      return surface.base * (1.0F + 0.20F * fractal_noise(uv, 4.0F, shortest_m, 0.7F, surface.key));
    case Material::kPaving:
    case Material::kWall:
    case Material::kChimney:
      return surface.base *
             (1.0F + 0.08F * fractal_noise(uv, 2.0F, shortest_m, 0.6F, surface.face_key));
    default:
      return surface.base;
  }
}

}  // namespace ridgeline::simulate
