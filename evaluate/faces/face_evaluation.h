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

/// What became of a face. Every input face has exactly one status.
enum class FaceStatus : std::uint8_t {
  kEvaluated,
  kNoLidar,     ///< outside the cloud, or too few points over the face
  kNoPlane,     ///< there are points, but no plane like the face's holds enough of them
  kTooSmall,    ///< in plan, or too few points away from its outline
  kSteep,       ///< a wall, which is not seen from above
  kDegenerate,  ///< RoofFace::degenerate
};
/// The name of a status as in the files: `evaluated`, `no_lidar`, ...
const char* name(FaceStatus status);

/// A figure with its 95 % interval, value +- half_width.
struct Estimate {
  double value = 0.0;
  double half_width = 0.0;
};

/// How far a face's plane is from that of its points, model minus scan.
///
/// The intervals take the points' errors as independent, with a sigma estimated from their
/// residuals (Student's t with n - 3 degrees of freedom). Where neighbours err together, as in the
/// strips of a scanner, they are too narrow.
struct PlaneDifference {
  Estimate shift_m;   ///< along the face's normal at its centroid, positive if the face is too high
  Estimate height_m;  ///< the same vertically
  Estimate angle_deg;  ///< between both planes, not negative
  /// Parts of the angle in the face's own axes, which level faces have too. `along` is positive if
  /// the face rises more than its points up its own slope; `across`, if it rises more to the left
  /// of that. The slope of a level face is towards y.
  Estimate along_deg, across_deg;
  /// Slope of the face minus that of its points, positive if the face is too steep. Empty if both
  /// are below 5 degrees.
  std::optional<Estimate> pitch_deg;
  /// Direction of the face's fall minus that of its points, clockwise from above, from -180 to 180.
  /// Empty if one of both slopes is below 5 degrees.
  std::optional<Estimate> aspect_deg;
};

/// Where an edge of a face's outline should be by the points beside it.
struct EdgeOffset {
  std::size_t edge = 0;  ///< place in PlanPolygon::edges()
  /// How far the edge lies outwards of the border of the points on the plane; negative if the face
  /// is too small. At most kFaceReach_m either way: then the border may be farther off.
  double offset_m = 0.0;
  /// Points that speak for this place rather than for the edge's own: those that its plane lacks,
  /// or has beyond the edge.
  int n_contradictions = 0;
};

/// What is wrong with a face. Several may be.
struct FaceVerdict {
  bool height = false, tilt = false, outline = false;
  [[nodiscard]] bool right() const { return !height && !tilt && !outline; }
};
/// "right", "height", "tilt", "outline", or several of the latter: "height+outline".
std::string text(const FaceVerdict& verdict);

/// The judgement of one face. All but id, status and the areas is set only for status `evaluated`,
/// n_over also otherwise.
struct FaceEvaluation {
  std::string id;
  FaceStatus status = FaceStatus::kDegenerate;
  double area_m2 = 0.0;       ///< on its plane
  double plan_area_m2 = 0.0;  ///< in plan
  int n_over = 0;             ///< points over the face in plan
  int n_unexplained = 0;      ///< of these, on no plane of this face or of one within reach; all of
                              ///< them without a plane

  PlaneFit fit;  ///< of the points of the face; `n` of them
  PlaneDifference difference;
  double share_on_plane = 0.0;  ///< of the points over the face, without those near its outline
  double covered_share = 0.0;   ///< of the area in plan that has points on the plane nearby
  /// Area in plan beside the face, within reach, where its plane goes on in the points and no other
  /// face lies on it.
  double beyond_m2 = 0.0;
  /// Area in plan within the face where the points lie elsewhere, also on its chimneys and dormers.
  double missing_m2 = 0.0;
  std::vector<EdgeOffset> edges;  ///< of those that are long enough, see outline.h
  FaceVerdict verdict;
};

}  // namespace ridgeline::evaluate
