// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_support.h"
#include "evaluate/line_evaluation.h"

#include <optional>
#include <vector>

namespace ridgeline::evaluate {

/// Marks the candidates that are cars, boxes or terraces on a level surface: small, level, less
/// than 2 m above a level candidate that lies on both sides of the line. The line beside one is a
/// marking or a border of the surface below, unless the images show that it is the object's edge.
void mark_low_objects(std::vector<CandidatePlane>& candidates,
                      double spacing_m,
                      const std::optional<ImageEvidence>& images,
                      const JudgeOptions& options);

}  // namespace ridgeline::evaluate
