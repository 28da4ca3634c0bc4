// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_support.h"

#include <vector>

namespace ridgeline::evaluate {

/// Marks the candidates that are cars, boxes or terraces on a level surface: small, level, less
/// than 2 m above a level candidate that lies on both sides of the line. The line beside one is likely to be a
/// marking or a border of the surface below.
void mark_low_objects(std::vector<CandidatePlane>& candidates,
                      double spacing_m,
                      const JudgeOptions& options);

}  // namespace ridgeline::evaluate
