// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/surface_hypotheses.h"

#include <array>

namespace ridgeline::evaluate {

/// Weights of the terms, by maximum likelihood; docs/calibration.md names the data.
inline constexpr std::array<double, kNumPlanTerms> kPlanWeights{
    4.0,   // kIsUpper
    1.0,   // kIsLower
    0.5,   // kIsGround
    -3.0,  // kStepMissing
    -3.0,  // kGap
    -1.0,  // kUpperReach
    0.0,   // kLowerReach
    -2.0,  // kCovered
    -3.0,  // kFewPoints
    -4.0,  // kIsLowObject
    0.0,   // kIsLedge
    8.0,   // kIsMeeting
    -4.0,  // kMeetingOffset
    -4.0,  // kMeetingDirection
    -3.0,  // kMeetingMissing
    -0.5,  // kMeetingFlat
    0.0,   // kIsObject
    1.0,   // kOneSideEmpty
};
inline constexpr std::array<double, kNumPointTerms> kPointWeights{
    -10.0,  // kStandBeside
    -10.0,  // kStandIn
    4.0,    // kAccompany
};

/// Density of wrong lines in height against that of right ones at their surface.
inline constexpr double kWrongDensity_per_m = 0.01;
/// Weight of a sighting's chi-square: neighbouring pixels and images err together.
inline constexpr double kSightingWeight = 0.5;
/// The object's freedom to lie where the sightings are nearest.
inline constexpr double kObjectSeen = -3.0;

}  // namespace ridgeline::evaluate
