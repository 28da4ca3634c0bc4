// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

// Scenes are in local metres: x east, y north, z up, the patch centred on (0, 0), its ground near
// 0.
namespace ridgeline::other {

enum class Material : std::uint8_t {
  kGround,  ///< as its patches say
  kTiles,
  kMetal,
  kBitumen,
  kPlaster,
  kPanels,  ///< photovoltaic
  kBrick,
  kWood,
  kPaint,
  kGlass,
  kLeaves,
};

/// Material and colour (reflectance of red, green, blue, 0..1) of a part, as its maker chooses
/// them.
struct Look {
  Material material = Material::kPlaster;
  Eigen::Vector3d colour = Eigen::Vector3d::Constant(0.5);
  std::uint64_t seed = 0;  ///< of its texture
};

/// A plane convex polygon. Its first side is its lower one: textures run along it (u) and up from
/// it (v), metres from the first corner.
struct Face {
  std::vector<Eigen::Vector3d> corners;
  Look look;
};

struct Ellipsoid {
  Eigen::Vector3d centre, radii;
  Look look;
};

/// A straight edge of the scene. kind: ridge | hip | valley | eave | verge for roofs, else what it
/// belongs to: wall | chimney | fitting | joint | car | fence | ground | shadow.
struct Edge {
  Segment3 segment;
  std::string kind;
};

enum class Paving : std::uint8_t { kLawn, kField, kAsphalt, kSlabs, kGravel, kMarking };

/// A rectangle of the ground in plan; later ones lie upon earlier ones.
struct GroundPatch {
  Eigen::Vector2d centre, along;  ///< `along` of unit length
  Eigen::Vector2d half_size;      ///< along and across, metres
  Paving paving = Paving::kLawn;
  Eigen::Vector3d colour = Eigen::Vector3d::Constant(0.3);
  std::uint64_t seed = 0;
};

struct Scene {
  double half_extent_m = 36.0;                             ///< of the patch in plan
  Eigen::Vector2d ground_slope = Eigen::Vector2d::Zero();  ///< z of the ground = slope . (x, y)
  Eigen::Vector3d to_sun = Eigen::Vector3d::UnitZ();       ///< unit length
  std::vector<GroundPatch> ground;
  std::vector<Face> faces;  ///< the first one is the ground
  std::vector<Ellipsoid> ellipsoids;
  std::vector<Edge> edges;  ///< those of ground patches included, shadows not

  [[nodiscard]] double ground_m(const Eigen::Vector2d& x) const { return ground_slope.dot(x); }
  [[nodiscard]] Eigen::Vector3d on_ground(const Eigen::Vector2d& x) const {
    return {x.x(), x.y(), ground_m(x)};
  }
};

/// Index of the uppermost patch of the ground at `x`; -1 for none.
int patch_at(const Scene& scene, const Eigen::Vector2d& x);

/// Coordinates of `x` in a patch, metres along and across from its centre.
Eigen::Vector2d in_patch(const GroundPatch& patch, const Eigen::Vector2d& x);

/// Unit normal, by the right hand about the corners.
Eigen::Vector3d normal_of(const Face& face);

/// The segment that two plane convex polygons have in common; start = end if they have none.
Segment3 common_segment(const Face& a, const Face& b);

}  // namespace ridgeline::other
