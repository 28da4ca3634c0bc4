// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/options.h"
#include "evaluate/faces/outline.h"
#include "evaluate/faces/roof_face.h"
#include "evaluate/judge/point_search.h"

#include <span>

namespace ridgeline::evaluate {

/// The first half of a face's judgement: the plane of its points, or why there is none. Outline and verdict are not set.
FaceEvaluation judge_plane(const PointSearch& search,
                           const RoofFace& face,
                           const FaceOptions& options);

/// The second half, for an evaluation by judge_plane(): the outline, what the points over the face lie on, and the verdict.
/// @param neighbours  the other faces around, with their planes: where the points lie on a neighbour's plane as well, the face
///                    does not go on beyond its outline
void judge_outline(const PointSearch& search,
                   const RoofFace& face,
                   std::span<const NeighbourFace> neighbours,
                   const FaceOptions& options,
                   FaceEvaluation& evaluation);

/// Both halves for a face that stands alone. Every face gets a status; a bad face never throws.
FaceEvaluation judge_face(const PointSearch& search,
                          const RoofFace& face,
                          const FaceOptions& options);

}  // namespace ridgeline::evaluate
