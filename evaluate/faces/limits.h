// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// How faces of building models are judged; see judge_faces(). Metres of the local frame, degrees.
/// Noise of the cloud, inliers and sample consensus are those of JudgeOptions, as for lines; a face
/// steeper than JudgeOptions::max_slope_deg is a wall.
namespace ridgeline::evaluate {

/// A plane whose height differs from the face's own by more than this is another surface.
inline constexpr double kMaxFaceHeight_m = 2.0;
inline constexpr double kMaxFaceTilt_deg = 15.0;  ///< the same for the angle between the two planes
/// Points closer to the outline than this are not used in the fit: they straddle the edge, as for
/// lines.
inline constexpr double kBorderGap_m = 0.2;
inline constexpr double kMinFaceArea_m2 = 2.0;  ///< in plan; smaller faces are `too_small`
/// A plane must hold this share of the points over the face.
inline constexpr double kMinShareOnPlane = 0.3;
inline constexpr double kFaceReach_m = 1.5;  ///< how far from the outline the true one is sought

inline constexpr double kHeightTolerance_m = 0.10;   ///< 3 sigma of the cloud
inline constexpr double kTiltTolerance_deg = 1.0;    ///< 9 cm at the ridge of a face of 5 m
inline constexpr double kOutlineTolerance_m = 0.30;  ///< of an edge of the outline
/// At least this many more points must support another position of an edge than its own. If one
/// point in ten lies on the wrong surface, five points give odds of 9^5 to 1.
inline constexpr int kMinContradictions = 5;

/// If more than this share of the points over a building's faces lie on none of its planes, the
/// building lacks faces. Unmodelled dormers and chimneys usually stay below it.
inline constexpr double kMaxUnexplained = 0.25;
inline constexpr double kMaxWrongShare = 0.25;  ///< of a building's judged area

}  // namespace ridgeline::evaluate
