// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/face_points.h"
#include "evaluate/faces/neighbour_face.h"
#include "evaluate/judge/options.h"

#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// What a point indicates about a face's outline.
enum class PointPlace : std::uint8_t {
  kOnFace,
  kOnFaceOrOther,  ///< on both planes, closer to the face's: near their intersection
  kOtherOrOnFace,  ///< on both planes, closer to the other one
  kElsewhere,      ///< below the face's plane, or on another one
  kAbove,    ///< above the face's plane and on no other: its ray ended before reaching the face
  kUnknown,  ///< it may belong to either: nearly identical planes, one face above the other, or a
             ///< neighbour without a plane
};

struct PlacedPoint {
  PointPlace place = PointPlace::kUnknown;
  bool explained = false;  ///< it lies on the plane of the face or of a neighbour within reach
};

/// The places of the points_around() a face, in the order of the points.
/// @param neighbours  other faces, including those of other buildings; those out of reach have no
/// effect
std::vector<PlacedPoint> placed_points(std::span<const FacePoint> points,
                                       const RoofFace& face,
                                       const PlaneFit& fit,
                                       std::span<const NeighbourFace> neighbours,
                                       const JudgeOptions& options);

/// For each edge of the outline, the position that the points beside it support; if there are
/// several, the one closest to the edge itself. A face is too large where its plane has no points
/// in a strip along the edge although rays passed through, and too small where its plane continues.
/// Points below the plane are not in themselves evidence that it is too large: oblique rays hit
/// walls and ground under an overhang. An edge with fewer than twice kMinContradictions points
/// beside it is left out.
/// @param points_per_m2  of the face on its plane, per area in plan
std::vector<EdgeOffset> edge_offsets(std::span<const FacePoint> points,
                                     std::span<const PlacedPoint> places,
                                     const RoofFace& face,
                                     double points_per_m2);

/// Whether an edge is off by more than the tolerance, according to enough points.
bool is_off(const EdgeOffset& edge);
/// Whether is_off() holds for one of the edges.
bool is_outline_wrong(std::span<const EdgeOffset> edges);

}  // namespace ridgeline::evaluate
