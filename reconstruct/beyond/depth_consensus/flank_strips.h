// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/line_match.h"
#include "reconstruct/views/match_view.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Both sides of an image line, sampled in rows parallel to it.
struct FlankStrip {
  static constexpr int kRows = 5;
  static constexpr double kFirstRow_px = 2.0;  ///< clear of the blurred edge
  static constexpr double kRowStep_px = 1.0;
  static constexpr double kLeftStep_px = 1.0;  ///< of the samples along
  static constexpr double kRightStep_px = 0.5;

  Segment2 axis;    ///< on the line, from the first sample to the last one; ideal pixels
  int n_along = 0;  ///< samples of a row; 0: not sampled
  int n_bands = 0;
  /// Whether the segment starts and ends at the border of its image: it is cut there.
  std::array<bool, 2> is_cut{};
  /// Towards n = (-u_y, u_x), u along the axis, and away from it: row after row, of each its bands,
  /// of each the samples along. NaN outside of the image.
  std::array<std::vector<float>, 2> sides;

  [[nodiscard]] const float* row(std::size_t side, int row, int band) const {
    return sides[side].data() + static_cast<std::ptrdiff_t>(row * n_bands + band) * n_along;
  }
};

/// The strips of a match. The left strip is as long as its segment, the right one reaches as far beyond its own
/// as the left one may be seen.
struct FlankStrips {
  FlankStrip left, right;
};

/// The strips beside the matches up to `max_angle_deg` to the epipolar line, by match; empty ones
/// beside the others.
std::vector<FlankStrips> sample_flanks(const StereoPair& pair,
                                       std::span<const LineMatch> matches,
                                       double max_angle_deg);

}  // namespace ridgeline::reconstruct
