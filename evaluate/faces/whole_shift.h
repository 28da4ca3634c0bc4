// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/roof_face.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace ridgeline::evaluate {

/// By how much a building as a whole is displaced from its scan (model minus scan, local metres),
/// if this displacement is its only error: the least squares solution from its faces' shifts along
/// their normals and its outlines' offsets across their edges, provided that without the
/// displacement all but kMaxWrongShare of its judged area is right. Empty otherwise, or if faces
/// and outlines do not determine all three components. Offsets within 0.2 m of kFaceReach_m are not
/// used, because the border may lie farther away.
/// @param evaluations  of the faces, in their order
std::optional<Eigen::Vector3d> whole_shift_m(std::span<const RoofFace> faces,
                                             std::span<const FaceEvaluation> evaluations);

}  // namespace ridgeline::evaluate
