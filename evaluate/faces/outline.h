// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/face_points.h"
#include "evaluate/faces/neighbour_face.h"
#include "evaluate/faces/options.h"

#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// What a point says of a face's outline.
enum class PointPlace : std::uint8_t {
  kOnFace,
  kOnFaceOrOther,  ///< on both planes, nearer to the face's: beside their intersection
  kOtherOrOnFace,  ///< on both planes, nearer to the other one
  kElsewhere,
  kUnknown,  ///< it may belong to either: planes that are nearly one, faces one above the other, or a neighbour without a plane
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
                                       const FaceOptions& options);

/// For each edge of the outline the place where it contradicts the fewest of the points beside it: points on the face must lie
/// inwards of it, others outwards. Of several such places it is the nearest to the edge's own, so that an edge that no point
/// contradicts is right. An edge with fewer than twice FaceOptions::min_contradictions points beside it is left out.
std::vector<EdgeOffset> edge_offsets(std::span<const FacePoint> points,
                                     std::span<const PlacedPoint> places,
                                     const RoofFace& face,
                                     const FaceOptions& options);

/// Whether an edge is off by more than the tolerance, by enough points.
bool is_outline_wrong(std::span<const EdgeOffset> edges, const FaceOptions& options);

}  // namespace ridgeline::evaluate
