// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/face_points.h"
#include "evaluate/faces/neighbour_face.h"
#include "evaluate/judge/options.h"

#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// What a point says of a face's outline.
enum class PointPlace : std::uint8_t {
  kOnFace,
  kOnFaceOrOther,  ///< on both planes, nearer to the face's: beside their intersection
  kOtherOrOnFace,  ///< on both planes, nearer to the other one
  kElsewhere,      ///< below the face's plane, or on another one
  kAbove,    ///< above the face's plane and on no other: its ray ended before it reached the face
  kUnknown,  ///< it may belong to either: planes that are nearly one, faces one above the other, or
             ///< a neighbour without a plane
};

struct PlacedPoint {
  PointPlace place = PointPlace::kUnknown;
  bool explained = false;  ///< it lies on the plane of the face or of a neighbour within reach
};

/// The places of points_around() a face, in their order.
/// @param neighbours  other faces, also of other buildings; those out of reach change nothing
std::vector<PlacedPoint> placed_points(std::span<const FacePoint> points,
                                       const RoofFace& face,
                                       const PlaneFit& fit,
                                       std::span<const NeighbourFace> neighbours,
                                       const JudgeOptions& options);

/// For each edge of the outline the place that the points beside it speak for, of several the
/// nearest to the edge's own. A face is too large where its plane has no points in a strip along
/// the edge although rays came through, and too small where its plane goes on. Points below the
/// plane do not show by themselves that it is too large: slanting rays meet walls and ground under
/// an overhang. An edge with fewer than twice kMinContradictions points beside it is
/// left out.
/// @param points_per_m2  in plan, of the face on its plane
std::vector<EdgeOffset> edge_offsets(std::span<const FacePoint> points,
                                     std::span<const PlacedPoint> places,
                                     const RoofFace& face,
                                     double points_per_m2);

/// Whether an edge is off by more than the tolerance, by enough points.
bool is_off(const EdgeOffset& edge);
/// Whether one of the edges is.
bool is_outline_wrong(std::span<const EdgeOffset> edges);

}  // namespace ridgeline::evaluate
