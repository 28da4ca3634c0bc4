// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/roof_face.h"

#include <optional>
#include <span>

namespace ridgeline::evaluate {

/// How much a building is too high where its roof's height is commonly given: model minus scan, in
/// metres, the mean over the edges by their lengths. Empty without such an edge of an evaluated
/// face.
struct EdgeHeights {
  /// Level upper edges of inclined faces, from which a neighbour falls away as well, if there is
  /// one. The scan's height is that of the line in which the planes of both faces' points meet, so
  /// that a ridge at the wrong place is not a wrong height; with one plane only, that of the plane
  /// above the edge.
  std::optional<double> ridge_m;
  /// Level lower edges of inclined faces and the edges of level faces, where no other face joins
  /// them.
  std::optional<double> eave_m;
};

/// @param evaluations  of the faces, in their order
EdgeHeights edge_heights(std::span<const RoofFace> faces,
                         std::span<const FaceEvaluation> evaluations);

}  // namespace ridgeline::evaluate
