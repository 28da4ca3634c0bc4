// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/roof_face.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace ridgeline::evaluate {

/// By how much a building as a whole lies off its scan (model minus scan, local metres), if that
/// alone makes it wrong: the least squares solution of its faces' shifts along their normals and
/// its outlines' offsets across their edges, without which all but kMaxWrongShare of
/// its area is right. Nothing without it, or where faces and outlines do not fix all three
/// components. Offsets within 0.2 m of kFaceReach_m are not used: the border may be farther
/// off.
/// @param evaluations  of the faces, in their order
std::optional<Eigen::Vector3d> whole_shift_m(std::span<const RoofFace> faces,
                                             std::span<const FaceEvaluation> evaluations);

}  // namespace ridgeline::evaluate
