// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/roof_face.h"
#include "evaluate/judge/options.h"
#include "evaluate/judge/point_search.h"

#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// Judges every face of every building, in parallel; results are in the order of the buildings and
/// their faces and do not depend on the number of threads. Each face is judged by its own points;
/// the surrounding faces, including those of other buildings, only explain points beside and over
/// it. Ids of faces need not be unique. Throws std::invalid_argument for an option out of its
/// range.
std::vector<std::vector<FaceEvaluation>> judge_faces(const PointSearch& search,
                                                     std::span<const RoofBuilding> buildings,
                                                     const JudgeOptions& options);

}  // namespace ridgeline::evaluate
