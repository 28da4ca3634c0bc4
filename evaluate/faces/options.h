// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/options.h"
#include "reconstruct/geometry/field.h"

#include <tuple>

namespace ridgeline::evaluate {

/// How faces of building models are judged, see judge_faces(). Metres of the local frame, degrees.
struct FaceOptions {
  /// Noise of the cloud, inliers and sample consensus, as for lines. A face steeper than
  /// `max_slope_deg` is a wall.
  JudgeOptions judge;

  /// A plane that is farther from the face's own in height is another surface.
  double max_height_m = 2.0;
  double max_tilt_deg = 15.0;  ///< the same for the angle between both
  /// Points nearer to the outline are not fitted: they straddle the edge, as for lines.
  double border_gap_m = 0.2;
  double min_area_m2 = 2.0;  ///< in plan; smaller faces are `too_small`
  /// A plane must hold this share of the points over the face.
  double min_share = 0.3;
  double reach_m = 1.5;  ///< how far from the outline its true place is looked for

  double height_tolerance_m = 0.10;   ///< 3 sigma of the cloud
  double tilt_tolerance_deg = 1.0;    ///< 9 cm at the ridge of a face of 5 m
  double outline_tolerance_m = 0.30;  ///< of an edge of the outline
  /// So many points more must speak for an edge's other place than for its own. If one point in ten
  /// lies on the wrong surface, the odds of five are 9^5 to 1.
  int min_contradictions = 5;

  /// Above this share of points over a building's faces that lie on none of its planes, the
  /// building lacks faces. Unmodelled dormers and chimneys are below it as a rule.
  double max_unexplained = 0.25;
  double max_wrong_share = 0.25;  ///< of a building's judged area; above, the building is wrong

  static constexpr auto fields() {
    using O = FaceOptions;
    return std::tuple{
        Field{"max_height_m", &O::max_height_m, 0.0, 100.0,
              "largest difference in height between a face and its points"},
        Field{"max_tilt_deg", &O::max_tilt_deg, 0.0, 45.0,
              "largest angle between a face and the plane of its points"},
        Field{"border_gap_m", &O::border_gap_m, 0.0, 10.0,
              "points nearer to a face's outline are not fitted"},
        Field{"min_area_m2", &O::min_area_m2, 0.0, 1000.0, "smaller faces are too_small"},
        Field{"min_share", &O::min_share, 0.0, 1.0,
              "share of a face's points that its plane must hold"},
        Field{"reach_m", &O::reach_m, 0.1, 10.0,
              "how far from an outline its true place is looked for"},
        Field{"height_tolerance_m", &O::height_tolerance_m, 0.0, 100.0,
              "a larger shift is a wrong height"},
        Field{"tilt_tolerance_deg", &O::tilt_tolerance_deg, 0.0, 90.0,
              "a larger angle is a wrong tilt"},
        Field{"outline_tolerance_m", &O::outline_tolerance_m, 0.0, 10.0,
              "a larger offset of an edge is a wrong outline"},
        Field{"min_contradictions", &O::min_contradictions, 1, 1000000,
              "points that an edge's wrong place needs"},
        Field{"max_unexplained", &O::max_unexplained, 0.0, 1.0,
              "share of points on none of a building's planes that it may have"},
        Field{"max_wrong_share", &O::max_wrong_share, 0.0, 1.0,
              "share of a building's judged area that may be wrong"}};
  }
};

}  // namespace ridgeline::evaluate
