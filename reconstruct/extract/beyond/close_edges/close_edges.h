// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/colour_profile.h"
#include "reconstruct/geometry/segment.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <optional>

namespace ridgeline::reconstruct {

/// One of the steps of the colour profile across a segment: a line beside the segment's own.
/// Offsets are along n = (-u_y, u_x), u = end - start.
struct ProfileStep {
  double offset_px = 0.0;  ///< in the middle of the segment
  double tilt_px = 0.0;    ///< the offset is larger by this at the end, smaller at the start
  double height = 0.0;     ///< root of the summed squares of the bands' steps
};

/// Finds the two edges that make up one segment.
///
/// Edges within about two pixels, in a soft image within two blurs, blur into one: the edge of a
/// roof and the strip of wall below it, which one of the cameras sees, or both borders of a road
/// marking. The maximum of the gradient then lies on neither edge; it is off by up to half the
/// strip. The pixels along the segment sample the profile across it at many phases, so that the
/// profile is known far below a pixel. Per band it is
///
///     I(s) = c_0 + c_1 Phi((s - x_1) / blur) + c_2 Phi((s - x_2) / blur),
///
/// with x_1 < x_2 common to the bands and Phi the normal distribution. The offsets are found by
/// exhaustive search, then by least squares with a tilt for each line. Nothing is returned if one
/// step describes the profile about as well, if two steps the same way are so close that a wider
/// blur would explain them, if one step hardly counts beside the other, or if the least squares
/// leave the neighbourhood of what was found.
class CloseEdgeFinder {
 public:
  /// @param blur_px  the blur of the image's edges, edge_blur_px(); above 0
  explicit CloseEdgeFinder(double blur_px);

  /// The two edges in the order of their offsets, if there are two.
  /// @param image  CV_32FC(n), n = 1..4
  [[nodiscard]] std::optional<std::array<ProfileStep, 2>> find(const cv::Mat& image,
                                                               const Segment2& segment) const;

 private:
  double unit_px_;  ///< of the profiles: their edges are at most one unit wide
  double blur_;     ///< in units
  StepBasis basis_;
};

}  // namespace ridgeline::reconstruct
