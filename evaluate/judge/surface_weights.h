// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/surface_hypotheses.h"

#include <array>

namespace ridgeline::evaluate {

// By maximum likelihood; docs/calibration.md names the data.

inline constexpr std::array<double, kNumPlanTerms> kPlanWeights{
    0.00,  // kUpperBorder, -0.8 m
    0.00,  // kUpperBorder, -0.3 m
    0.00,  // kUpperBorder, 0 m
    0.00,  // kUpperBorder, 0.3 m
    0.00,  // kUpperBorder, 0.6 m
    0.00,  // kUpperBorder, 1.2 m
    0.00,  // kLowerBorder, -0.8 m
    0.00,  // kLowerBorder, -0.3 m
    0.00,  // kLowerBorder, 0 m
    0.00,  // kLowerBorder, 0.3 m
    0.00,  // kLowerBorder, 0.6 m
    0.00,  // kLowerBorder, 1.2 m
    0.00,  // kIsGround
    0.00,  // kLowStep
    0.00,  // kUnderLowBorder
    0.00,  // kCovered
    0.00,  // kMissing
    0.00,  // kFewPoints
    0.00,  // kLowerFewPoints
    0.00,  // kIsLowObject
    0.00,  // kIsLedge
    0.00,  // kIsMeeting
    0.00,  // kMeetingOffset
    0.00,  // kMeetingDirection
    0.00,  // kMeetingMissing
    0.00,  // kMeetingFlat
    0.00,  // kOneSideEmpty
};
inline constexpr std::array<double, kNumPointTerms> kPointWeights{
    0.00,  // kStandBeside
    0.00,  // kStandIn
    0.00,  // kStandLower
    0.00,  // kAccompany
};

/// Share of wrong lines over the heights that they may have, against that of right ones.
inline constexpr double kWrongDensity_per_m = 0.0055;
/// Weight of a sighting's chi-square: neighbouring pixels and images err together.
inline constexpr double kSightingWeight = 0.5;
/// An object fits the sightings better, as it may lie where they are nearest.
inline constexpr double kObjectSeen = -3.0;

}  // namespace ridgeline::evaluate
