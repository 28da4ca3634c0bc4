// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/plan_geometry.h"
#include "io/crs/crs.h"
#include "io/lines/line_set.h"
#include "io/models/building_model.h"
#include "reconstruct/geometry/local_frame.h"
#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace ridgeline::simulate {

/// What a surface is made of. It determines the laser class, the returns and the appearance in
/// images.
enum class Material : std::uint8_t {
  kGround,
  kStreet,
  kMarking,
  kRoof,
  kGutter,  ///< fascia below an eave
  kWall,
  kChimney,
  kFoliage,  ///< leaves: a pulse may pass through
  kWood,     ///< trunks and fences
  kCar,
  kGlass,   ///< panes
  kFrame,   ///< window frames
  kSolar,   ///< solar panels, frames of skylights
  kPaving,  ///< terraces and paths
  kGardenWall,
};

/// Stands for an id that does not exist: the building of a tree, the plane of a leaf.
inline constexpr int kNone = -1;

struct Triangle {
  std::array<std::int32_t, 3> vertices{};  ///< counter-clockwise seen from outside
  std::int32_t building_id = kNone;
  std::int32_t plane_id =
      kNone;  ///< index into SyntheticScene::planes; kNone for walls, leaves, cars
  Material material = Material::kGround;
  std::int32_t object_id = kNone;  ///< id of a tree, car or fence, none of which has a building id
};

/// All surfaces of a scene, local metres. Bodies may penetrate each other (a dormer its roof);
/// parts inside another body are never visible from outside.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Triangle> triangles;
};

enum class PlaneKind : std::uint8_t { kRoof, kGround, kChimney, kWallTop };

/// Unit normal of a triangle, outwards.
Eigen::Vector3d triangle_normal(const Mesh& mesh, int triangle);

/// A planar face as built, before other bodies cover parts of it.
struct ScenePlane {
  int id = 0;                                   ///< index into SyntheticScene::planes
  Plane3 plane{Eigen::Vector3d::UnitZ(), 0.0};  ///< local, normal upwards
  std::vector<Eigen::Vector3d> outline;         ///< convex, counter-clockwise from above
  int building_id = kNone;
  PlaneKind kind = PlaneKind::kRoof;
};

enum class LineKind : std::uint8_t {
  kRidge,    ///< horizontal convex intersection of two roof planes
  kHip,      ///< inclined convex intersection
  kValley,   ///< concave intersection
  kEave,     ///< horizontal border of one roof plane
  kVerge,    ///< inclined border of one roof plane
  kGround,   ///< border of a street or a marking
  kJoint,    ///< where a roof plane meets the wall of another body; not a true line
  kFoot,     ///< where a wall meets the ground or a lower roof, on that surface; eaves may hide it
  kWallTop,  ///< top edge of a garden wall
  kObject,   ///< edge of a car or a chimney, whose surfaces are too small for a plane of laser
             ///< points
};

/// The name of the kind in files: `ridge`, `hip`, ...
const char* name(LineKind kind);

/// An edge of the top surface. It lies exactly on its planes and, unless it is a foot, is not
/// covered by another part of a building; trees may hide it.
struct SceneLine {
  Segment3 segment{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};  ///< local
  LineKind kind = LineKind::kRidge;
  std::vector<int> plane_ids;  ///< two for ridge, hip, valley; none for object; otherwise one
  int building_id = kNone;
};

enum class RoofType : std::uint8_t {
  kGabled,
  kHipped,
  kFlat,
  kParapet,
  kShed,
  kLShaped,
  kGabledDormers,
  kShedDormers,
  kRow,  ///< one of several adjoining gabled houses with steps in height
};
inline constexpr int kNumRoofTypes = 9;
const char* name(RoofType type);

struct SceneBuilding {
  int id = 0;  ///< index into SyntheticScene::buildings
  RoofType type = RoofType::kGabled;
  double ridge_azimuth_rad = 0.0;             ///< angle of the main ridge to the x axis, in [0, pi)
  double pitch_rad = 0.0;                     ///< pitch of the main roof
  std::vector<ConvexPolygon> footprint;       ///< wall outlines of its parts
  std::vector<ConvexPolygon> roof_footprint;  ///< roof outlines of its parts, with the overhangs
};

/// A synthetic village with its exact truth. All coordinates are local; world = local +
/// frame.origin_m.
struct SyntheticScene {
  LocalFrame frame;
  io::Crs crs;
  Eigen::Vector2d extent_m = Eigen::Vector2d::Zero();  ///< the plan is [0, x] x [0, y]
  PlanFunction mean_terrain;                           ///< height of the ground without terraces
  Mesh mesh;
  std::vector<ScenePlane> planes;
  std::vector<SceneLine> lines;   ///< true lines
  std::vector<SceneLine> joints;  ///< of kind kJoint; they close the outlines of the visible faces
  std::vector<SceneBuilding> buildings;
  /// The faces of the buildings, grouped by building, see true_faces(). Outer rings are
  /// counter-clockwise seen from outside, holes clockwise.
  std::vector<Face> faces;
};

/// The true lines in the CRS of the scene. Their id is the index in SyntheticScene::lines. They
/// have no class, and no covariance because they are exact.
io::LineSet true_lines(const SyntheticScene& scene);

/// The buildings in the CRS of the scene, with their faces and randomly drawn attributes. Building
/// "7" of the true lines is called "building_7", because CityGML ids begin with a letter.
io::BuildingModel true_model(const SyntheticScene& scene);

/// Mean |distance| of a segment (local) to the planes of true line `line_id`, averaged over the
/// planes: the value that an error-free evaluation would report. Throws std::invalid_argument for
/// an unknown line and one without planes.
double true_mean_distance(const SyntheticScene& scene, const Segment3& segment, int line_id);

}  // namespace ridgeline::simulate
