// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"

#include <array>
#include <cstdint>

namespace ridgeline::evaluate {

/// Judged lines by the evidence that decided on their surface. The place is the line's own height,
/// which a wrong line has, too, and points without a plane say little; so their figures are not
/// mixed with the others.
enum class DecidedGroup : std::uint8_t {
  kPlanImages,   ///< the headline of every table
  kPointsPlace,  ///< a row of its own
};
inline constexpr std::array kDecidedGroups{DecidedGroup::kPlanImages, DecidedGroup::kPointsPlace};

/// `plan_images` or `points_place`.
inline const char* name(DecidedGroup group) {
  return group == DecidedGroup::kPlanImages ? "plan_images" : "points_place";
}

/// The group of a line that is `evaluated`. One whose results do not say what decided counts as
/// decided by plan and images.
inline DecidedGroup decided_group(const LineEvaluation& line) {
  const bool is_of_place =
      line.decided_by == DecidedBy::kPoints || line.decided_by == DecidedBy::kPlace;
  return is_of_place ? DecidedGroup::kPointsPlace : DecidedGroup::kPlanImages;
}

}  // namespace ridgeline::evaluate
