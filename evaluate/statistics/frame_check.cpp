// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/frame_check.h"

#include "evaluate/statistics/distribution.h"
#include "reconstruct/geometry/check.h"

#include <fmt/format.h>

namespace ridgeline::evaluate {
namespace {

/// Whether points were sought beside a line of this status, or it is too far away to have any.
bool was_looked_up(Status status) {
  switch (status) {
    case Status::kNotReconstructed:
    case Status::kDegenerate:
    case Status::kTooShort:
    case Status::kNonFinite:
    case Status::kDuplicateId:
    case Status::kUnconfirmed:
      return false;
    default:
      return true;
  }
}

}  // namespace

FrameCheck check_frame(std::span<const LineEvaluation> lines, double tolerance_m) {
  constexpr double kMaxTolerances = 20.0;
  constexpr double kMinNearShare = 0.05;
  check(tolerance_m > 0.0, "check_frame: tolerance_m = ", tolerance_m, ", must be > 0");
  std::vector<double> distances_m;
  std::size_t n_looked_up = 0;
  std::size_t n_near = 0;
  std::size_t n_far_in_height = 0;
  for (const LineEvaluation& line : lines) {
    if (line.status == Status::kEvaluated) distances_m.push_back(*line.mean_distance_m);
    if (!was_looked_up(line.status)) continue;
    ++n_looked_up;
    // a line that is not in_range() has length 0; this one has a marker for a missing height
    if (line.status == Status::kOutOfRange && line.length_m > 0.0) ++n_far_in_height;
    if (line.status != Status::kNoLidar && line.status != Status::kOutOfRange) ++n_near;
  }
  FrameCheck result;
  result.median_distance_m = median(std::move(distances_m));
  if (n_looked_up == 0) return result;
  result.near_share = static_cast<double>(n_near) / static_cast<double>(n_looked_up);
  if (*result.near_share < kMinNearShare) {
    result.reason = fmt::format("only {} of {} lines are near the cloud, at least 5 % must be",
                                n_near, n_looked_up);
    if (n_far_in_height > 0) {
      result.reason +=
          fmt::format(" ({} have the same height more than {:.0f} m above or below it)",
                      n_far_in_height, kMaxHeightOffset_m);
    }
  } else if (result.median_distance_m.value_or(0.0) > kMaxTolerances * tolerance_m) {
    result.reason = fmt::format(
        "the median distance of the lines is {:.1f} m; line errors explain at most {:.1f} m",
        *result.median_distance_m, kMaxTolerances * tolerance_m);
  }
  result.same_frame = result.reason.empty();
  return result;
}

}  // namespace ridgeline::evaluate
