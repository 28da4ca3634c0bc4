// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/flight_plan.h"

#include "reconstruct/geometry/check.h"

#include <regex>

namespace ridgeline::other {

FlightPlan flight_plan(const std::string& text) {
  constexpr int kMaxViews = 12;
  // Three digits are enough to say that a number is too large, and none of them overflows.
  static const std::regex pattern("strip:([0-9]{1,3})(?:,cross:([0-9]{1,3}))?");
  std::smatch numbers;
  check(std::regex_match(text, numbers, pattern), "views = ", text,
        ", must be strip:N or strip:N,cross:M");
  const bool has_cross = numbers[2].matched;
  const FlightPlan plan{std::stoi(numbers[1]), has_cross ? std::stoi(numbers[2]) : 0};
  check(plan.strip >= 2, "views = ", text, ", must have at least 2 in the strip");
  check(!has_cross || plan.cross >= 1, "views = ", text,
        ", must have at least 1 in the cross strip");
  check(plan.strip + plan.cross <= kMaxViews, "views = ", text, ", must be at most ", kMaxViews,
        " in all");
  return plan;
}

}  // namespace ridgeline::other
