// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/plane_fit.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// The outcome for a face. Every input face has exactly one status.
enum class FaceStatus : std::uint8_t {
  kEvaluated,
  kNoLidar,     ///< outside the cloud, or too few points over the face
  kNoPlane,     ///< there are points, but no plane similar to the face's holds enough of them
  kTooSmall,    ///< too small in plan, or too few points away from its outline
  kSteep,       ///< a wall, which cannot be seen from above
  kDegenerate,  ///< RoofFace::degenerate
};
/// The name of a status as used in the files: `evaluated`, `no_lidar`, ...
const char* name(FaceStatus status);

/// A value with its 95 % interval, value +- half_width.
struct Estimate {
  double value = 0.0;
  double half_width = 0.0;
};

/// How far a face's plane is from that of its points, model minus scan.
///
/// The intervals assume that the points' errors are independent, with a sigma estimated from their
/// residuals (Student's t with n - 3 degrees of freedom). They are too narrow if neighbouring
/// points have similar errors, as in the strips of a scanner.
struct PlaneDifference {
  Estimate shift_m;   ///< along the face's normal at its centroid, positive if the face is too high
  Estimate height_m;  ///< the same, measured vertically
  Estimate angle_deg;  ///< between the two planes, not negative
  /// Components of the angle in the face's own axes, which are also defined for level faces.
  /// `along` is positive if the face rises more than its points up its own slope; `across`, if it
  /// rises more to the left of that direction. The slope direction of a level face is y.
  Estimate along_deg, across_deg;
  /// Slope of the face minus that of its points, positive if the face is too steep. Empty if both
  /// slopes are below 5 degrees.
  std::optional<Estimate> pitch_deg;
  /// Downslope direction of the face minus that of its points, clockwise seen from above, from -180
  /// to 180. Empty if either slope is below 5 degrees.
  std::optional<Estimate> aspect_deg;
};

/// Where an edge of a face's outline should be, according to the points beside it.
struct EdgeOffset {
  std::size_t edge = 0;  ///< index in PlanPolygon::edges()
  /// How far the edge lies outside the border of the points on the plane; negative if the face is
  /// too small. At most kFaceReach_m either way; at that limit the border may lie farther away.
  double offset_m = 0.0;
  /// Number of points that support this position rather than the edge's own: those that are missing
  /// on the face's plane, or that lie on it beyond the edge.
  int n_contradictions = 0;
};

/// What is wrong with a face; several may apply.
struct FaceVerdict {
  bool height = false, tilt = false, outline = false;
  [[nodiscard]] bool right() const { return !height && !tilt && !outline; }
};
/// "right", "height", "tilt", "outline", or several of the latter: "height+outline".
std::string text(const FaceVerdict& verdict);

/// The judgement of one face. Except for id, status, the areas, n_over and n_unexplained, all
/// fields are set only for status `evaluated`.
struct FaceEvaluation {
  std::string id;
  FaceStatus status = FaceStatus::kDegenerate;
  double area_m2 = 0.0;       ///< on its plane
  double plan_area_m2 = 0.0;  ///< in plan
  int n_over = 0;             ///< points over the face in plan
  int n_unexplained = 0;      ///< of these, those on the plane of neither this face nor one within
                              ///< reach; all of them if there is no plane

  PlaneFit fit;  ///< of the points of the face; `n` is their number
  PlaneDifference difference;
  double share_on_plane = 0.0;  ///< of the points over the face, except those near its outline
  double covered_share = 0.0;   ///< share of the area in plan that has points on the plane nearby
  /// Area in plan beside the face, within reach, where points continue its plane and lie on no
  /// other face.
  double beyond_m2 = 0.0;
  /// Area in plan within the face where the points lie elsewhere, including on its chimneys and
  /// dormers.
  double missing_m2 = 0.0;
  std::vector<EdgeOffset> edges;  ///< of the edges with enough points beside them; see outline.h
  FaceVerdict verdict;
};

}  // namespace ridgeline::evaluate
