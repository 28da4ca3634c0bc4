// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/colour_profile.h"
#include "reconstruct/geometry/segment.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <optional>

namespace ridgeline::reconstruct {

/// One of the steps of the colour profile across a segment: a line next to the segment's own line.
/// Offsets are along n = (-u_y, u_x), u = end - start.
struct ProfileStep {
  double offset_px = 0.0;  ///< in the middle of the segment
  double tilt_px = 0.0;    ///< the offset is this much larger at the end and smaller at the start
  double height = 0.0;     ///< root of the summed squares of the bands' steps
};

/// Finds the two edges that make up one segment.
///
/// Edges closer than about two pixels, or two blurs in a soft image, blur into one: for example, a
/// roof edge and the strip of wall below it, which one of the cameras sees, or both borders of a
/// road marking. The maximum of the gradient then lies on neither edge; it is off by up to half the
/// width of the strip. The pixels along the segment sample the profile across it at many phases, so
/// that the profile is known at a resolution far below a pixel. Per band it is
///
///     I(s) = c_0 + c_1 Phi((s - x_1) / blur) + c_2 Phi((s - x_2) / blur),
///
/// with x_1 < x_2 common to all bands and Phi the normal distribution. The offsets are found by
/// exhaustive search and refined by least squares with a tilt for each line. std::nullopt is
/// returned if a single step describes the profile about as well, if two steps in the same
/// direction are so close that a wider blur would explain them, if one step is negligible compared
/// with the other, or if the least squares solution moves away from the result of the search.
class CloseEdgeFinder {
 public:
  /// @param blur_px  blur of the edges of the image, edge_blur_px(); positive
  explicit CloseEdgeFinder(double blur_px);

  /// The two edges in the order of their offsets; std::nullopt if there are not two.
  /// @param image  CV_32FC(n), n = 1..4
  [[nodiscard]] std::optional<std::array<ProfileStep, 2>> find(const cv::Mat& image,
                                                               const Segment2& segment) const;

 private:
  double unit_px_;  ///< unit of the profiles, chosen so that the blur is at most one unit
  double blur_;     ///< in units
  StepBasis basis_;
};

}  // namespace ridgeline::reconstruct
