// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::test {

/// Shapes of roofs. In the building's own frame the ridge is parallel to x and the origin is the
/// centre of the footprint.
enum class RoofShape : std::uint8_t {
  kGable,
  kHip,
  kPyramid,
  kHalfHip,  ///< gable whose upper half is hipped
  kMansard,  ///< steep lower faces, a hip roof on top
  kShed,     ///< one face that rises with y
  kFlat,     ///< level, with a parapet all round
  kLShape,   ///< two gabled wings of equal width: one valley, one hip
  kTShape,   ///< gable with a narrower gabled wing in the middle of its side at -y: two valleys
  kDormer,   ///< gable with a gabled dormer on its side at -y, whose cut-out is a hole in the main
             ///< face
  kAnnex,    ///< gable with a lean-to in front of its wall at +y
};
inline constexpr int kNumRoofShapes = 11;

/// The shape, size and pose of a building to make. Its base is level, at the height of
/// `position`.
struct BuildingSpec {
  RoofShape shape = RoofShape::kGable;
  double length_m = 12.0;  ///< along the ridge; of both wings of an L
  double width_m = 8.0;    ///< of a wing of an L
  double eave_height_m = 5.0;
  double pitch_deg = 35.0;   ///< of the upper faces of a mansard; a lean-to always has 15 degrees
  double azimuth_deg = 0.0;  ///< turns the building about z, counter-clockwise from above
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< of the centre of its base, local
  /// Whether one roof face with four corners is split into two coplanar ones, while its neighbours
  /// keep their undivided edges.
  bool t_junctions = false;
};

enum class MadeSurface : std::uint8_t { kRoof, kWall, kGround };

/// A flat face. The outer ring comes first, then the holes; seen from outside the building, the
/// outer ring runs counter-clockwise and holes clockwise. The first vertex is not repeated at the
/// end of a ring.
struct MadeFace {
  MadeSurface kind = MadeSurface::kRoof;
  std::vector<std::vector<Eigen::Vector3d>> rings;  ///< local, m
};

/// The kind of a roof edge, in the terms of evaluate/judge/roof_kind.h.
///   ridge   level, two roof faces fall away from it (also the kink of a mansard)
///   hip     inclined, two roof faces fall away from it
///   valley  two roof faces rise from it
///   eave    border of an inclined face, more than 45 degrees from its slope in plan
///   verge   border of an inclined face, up to 45 degrees from its slope in plan
///   step    border of a level face, or the foot of a wall that rises from a roof face
enum class MadeEdgeKind : std::uint8_t { kRidge, kHip, kValley, kEave, kVerge, kStep };

struct MadeEdge {
  MadeEdgeKind kind = MadeEdgeKind::kRidge;
  Segment3 segment;  ///< local, m
};

/// A building as a closed shell: each edge of a face is shared by exactly one other face, in the
/// opposite direction, unless the spec asks for T-junctions. Roof faces come first.
struct MadeBuilding {
  BuildingSpec spec;
  std::vector<MadeFace> faces;
  std::vector<MadeEdge> edges;  ///< each edge of the roof once, undivided even at T-junctions
};

/// Throws std::invalid_argument if the sizes do not allow the shape (a hip roof wider than long).
MadeBuilding make_building(const BuildingSpec& spec);

/// The edges of the roof of a closed shell.
std::vector<MadeEdge> roof_edges(const std::vector<MadeFace>& faces);

}  // namespace ridgeline::test
