// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/neighbour_face.h"
#include "evaluate/faces/roof_face.h"
#include "evaluate/judge/options.h"
#include "evaluate/judge/point_search.h"

#include <span>

namespace ridgeline::evaluate {

/// Step 1: finds the plane of a face's points, or the reason why there is none.
FaceEvaluation find_plane(const PointSearch& search,
                          const RoofFace& face,
                          const JudgeOptions& options);

/// Step 2, for an evaluation from find_plane(): refits the plane without the points that may belong
/// to a neighbour, and computes the face's difference from it.
/// @param neighbours  the other faces around, with their planes from find_plane()
void refine_plane(const PointSearch& search,
                  const RoofFace& face,
                  std::span<const NeighbourFace> neighbours,
                  const JudgeOptions& options,
                  FaceEvaluation& evaluation);

/// Step 3: judges the outline, determines where the points over the face lie, and sets the verdict.
/// @param neighbours  as before: where the points also lie on a neighbour's plane, the face does
/// not continue beyond its outline
void judge_outline(const PointSearch& search,
                   const RoofFace& face,
                   std::span<const NeighbourFace> neighbours,
                   const JudgeOptions& options,
                   FaceEvaluation& evaluation);

/// All three steps for a face without neighbours. Every face gets a status; an invalid face never
/// throws.
FaceEvaluation judge_face(const PointSearch& search,
                          const RoofFace& face,
                          const JudgeOptions& options);

}  // namespace ridgeline::evaluate
