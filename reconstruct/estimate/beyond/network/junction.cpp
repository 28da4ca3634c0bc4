// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/network/junction.h"

#include "reconstruct/estimate/tracked_lines.h"

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

enum class MeetingPlace { kEnd, kWithin, kBeyond };

/// Where the crossings with another line lie on the segments of a line, averaged over the images
/// that show both.
MeetingPlace place_of(const ConditionedViews& frames,
                      const ObservedTrack& line,
                      const ObservedTrack& other) {
  constexpr double kAtEnd_px = 4.0;
  double to_end_px = 0.0;  // mean over the images: positive beyond the end, negative within
  const std::vector<SeenTogether> views = seen_together(line, other);
  const double share = 1.0 / static_cast<double>(views.size());
  for (const SeenTogether& view : views) {
    const Segment2& s = view.line.segment;
    const double t = parameter_along(s, view.crossing());
    to_end_px += share * frames.of(view.line).image.scale_px * length(s) * std::max(-t, t - 1.0);
  }
  if (to_end_px > kAtEnd_px) return MeetingPlace::kBeyond;
  return to_end_px < -kAtEnd_px ? MeetingPlace::kWithin : MeetingPlace::kEnd;
}

}  // namespace

Junction junction(const ConditionedViews& frames,
                  const ObservedTrack& a,
                  const ObservedTrack& b,
                  double sigma_meeting_m) {
  constexpr double kCorner = 0.87, kEndOnLine = 0.7, kCrossing = 0.35, kBeyondEnds = 0.45;
  const MeetingPlace of_a = place_of(frames, a, b);
  const MeetingPlace of_b = place_of(frames, b, a);
  if (of_a == MeetingPlace::kBeyond || of_b == MeetingPlace::kBeyond)
    return {kBeyondEnds, sigma_meeting_m};
  if (of_a == MeetingPlace::kEnd && of_b == MeetingPlace::kEnd)
    return {kCorner, 0.5 * sigma_meeting_m};
  const bool cross = of_a == MeetingPlace::kWithin && of_b == MeetingPlace::kWithin;
  return {cross ? kCrossing : kEndOnLine, 0.5 * sigma_meeting_m};
}

}  // namespace ridgeline::reconstruct
