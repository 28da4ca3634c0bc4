// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/roof_face.h"

#include <optional>
#include <span>

namespace ridgeline::evaluate {

/// How much too high a building is at the edges by which roof heights are usually specified: model
/// minus scan, in metres, averaged over the edges and weighted by their lengths. Empty if no
/// evaluated face has such an edge.
struct EdgeHeights {
  /// Level upper edges of inclined faces, from which the neighbour, if any, falls away as well. The
  /// scan's height is that of the line in which the planes fitted to the points of both faces meet,
  /// so that a ridge in the wrong position does not count as a wrong height; with only one plane,
  /// it is the height of that plane at the edge.
  std::optional<double> ridge_m;
  /// Level lower edges of inclined faces and the edges of level faces, where they adjoin no other
  /// face.
  std::optional<double> eave_m;
};

/// @param evaluations  of the faces, in their order
EdgeHeights edge_heights(std::span<const RoofFace> faces,
                         std::span<const FaceEvaluation> evaluations);

}  // namespace ridgeline::evaluate
