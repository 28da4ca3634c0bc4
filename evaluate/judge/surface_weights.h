// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/surface_hypotheses.h"

#include <array>

namespace ridgeline::evaluate {

// By maximum likelihood; docs/calibration.md names the data.

inline constexpr std::array<double, kNumPlanTerms> kPlanWeights{
    -0.11,  // kUpperBorder, -0.8 m
    1.10,   // kUpperBorder, -0.3 m
    3.76,   // kUpperBorder, 0 m
    0.85,   // kUpperBorder, 0.3 m
    1.56,   // kUpperBorder, 0.6 m
    2.49,   // kUpperBorder, 1.2 m
    -1.69,  // kLowerBorder, -0.8 m
    -0.18,  // kLowerBorder, -0.3 m
    0.33,   // kLowerBorder, 0 m
    -0.72,  // kLowerBorder, 0.3 m
    -0.06,  // kLowerBorder, 0.6 m
    -0.56,  // kLowerBorder, 1.2 m
    0.21,   // kIsGround
    1.07,   // kLowStep
    2.17,   // kUnderLowBorder
    0.66,   // kCovered
    -9.18,  // kMissing
    2.53,   // kFewPoints
    1.55,   // kLowerFewPoints
    -1.73,  // kIsLowObject
    0.11,   // kIsLedge
    -8.99,  // kStandBeside
    -0.06,  // kStandIn
    -0.51,  // kStandLower
    4.74,   // kIsMeeting
    -9.73,  // kMeetingOffset
    0.84,   // kMeetingDirection
    -0.85,  // kMeetingMissing
    2.67,   // kMeetingFlat
    -0.97,  // kOneSideEmpty
    0.64,   // kShort
};
/// Weight of SurfaceHypothesis::accompanied.
inline constexpr double kAccompaniedWeight = 6.92;

/// Share of wrong lines over the heights that they may have, against that of right ones.
inline constexpr double kWrongDensityPerMetre = 0.0020;
/// Weight of a sighting's chi-square: neighbouring pixels and images err together.
inline constexpr double kSightingWeight = 0.5;
/// An object fits the sightings better, as it may lie where they are nearest.
inline constexpr double kObjectSeen = -3.0;

}  // namespace ridgeline::evaluate
