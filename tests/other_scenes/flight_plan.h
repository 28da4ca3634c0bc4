// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace ridgeline::other {

/// How many views there are of a scene, by strip.
struct FlightPlan {
  int strip = 2;  ///< along the x axis, at least 2
  int cross = 0;  ///< of a strip at right angles to it
};

inline bool is_pair(const FlightPlan& plan) { return plan.strip == 2 && plan.cross == 0; }

/// The plan that "strip:N" or "strip:N,cross:M" says. Throws std::invalid_argument for another
/// text, fewer than 2 views in the strip, fewer than 1 in a cross strip, more than 12 in all.
FlightPlan flight_plan(const std::string& text);

}  // namespace ridgeline::other
