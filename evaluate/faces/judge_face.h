// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/neighbour_face.h"
#include "evaluate/faces/roof_face.h"
#include "evaluate/judge/options.h"
#include "evaluate/judge/point_search.h"

#include <span>

namespace ridgeline::evaluate {

/// First the plane of a face's points, or why there is none.
FaceEvaluation find_plane(const PointSearch& search,
                          const RoofFace& face,
                          const JudgeOptions& options);

/// Then, for an evaluation by find_plane(), the plane without the points that a neighbour may own,
/// and the face's difference to it.
/// @param neighbours  the other faces around, with their planes by find_plane()
void refine_plane(const PointSearch& search,
                  const RoofFace& face,
                  std::span<const NeighbourFace> neighbours,
                  const JudgeOptions& options,
                  FaceEvaluation& evaluation);

/// At last the outline, what the points over the face lie on, and the verdict.
/// @param neighbours  as before: where the points lie on a neighbour's plane as well, the face does
/// not go on beyond its outline
void judge_outline(const PointSearch& search,
                   const RoofFace& face,
                   std::span<const NeighbourFace> neighbours,
                   const JudgeOptions& options,
                   FaceEvaluation& evaluation);

/// All three for a face that stands alone. Every face gets a status; a bad face never throws.
FaceEvaluation judge_face(const PointSearch& search,
                          const RoofFace& face,
                          const JudgeOptions& options);

}  // namespace ridgeline::evaluate
