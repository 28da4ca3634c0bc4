// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/roof_face.h"

namespace ridgeline::evaluate {

/// How far a face is from the plane of its points. Neither may be vertical, and the angle between
/// them must be below 90 degrees.
PlaneDifference difference_of(const RoofFace& face, const PlaneFit& fit);

/// Whether a face's height and tilt are wrong, i.e. whether the whole interval lies beyond the
/// tolerance. A face with a wrong tilt is also too high or too low only if it is so by more than
/// the tolerance at all of its vertices; a face rotated about its eave or its ridge is not.
FaceVerdict plane_verdict(const RoofFace& face,
                          const PlaneFit& fit,
                          const PlaneDifference& difference);

}  // namespace ridgeline::evaluate
