// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"

#include <array>
#include <cstdint>

namespace ridgeline::evaluate {

/// Judged lines by the evidence that decided their surface. Place is the line's own height, which a
/// wrong line has too, and points without a plane are weak evidence; the figures of such lines are
/// therefore kept separate from the others.
enum class DecidedGroup : std::uint8_t {
  kPlanImages,   ///< the headline of every table
  kPointsPlace,  ///< in a separate row
};
inline constexpr std::array kDecidedGroups{DecidedGroup::kPlanImages, DecidedGroup::kPointsPlace};

/// `plan_images` or `points_place`.
inline const char* name(DecidedGroup group) {
  return group == DecidedGroup::kPlanImages ? "plan_images" : "points_place";
}

/// The group of a line that is `evaluated`. A line whose results do not include the deciding
/// evidence is assigned to plan and images.
inline DecidedGroup decided_group(const LineEvaluation& line) {
  const bool is_of_place =
      line.decided_by == DecidedBy::kPoints || line.decided_by == DecidedBy::kPlace;
  return is_of_place ? DecidedGroup::kPointsPlace : DecidedGroup::kPlanImages;
}

}  // namespace ridgeline::evaluate
