// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/roof_face.h"
#include "evaluate/judge/plane_fit.h"

namespace ridgeline::evaluate {

/// Another face, on which points beside a face may lie.
struct NeighbourFace {
  const RoofFace* face = nullptr;
  const PlaneFit* fit = nullptr;  ///< nullptr if no plane was found in its points
};

}  // namespace ridgeline::evaluate
