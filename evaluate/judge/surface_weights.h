// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/surface_hypotheses.h"

#include <array>

namespace ridgeline::evaluate {

// Estimated by maximum likelihood; docs/calibration.md names the data.

inline constexpr std::array<double, kNumPlanTerms> kPlanWeights{
    4.92,    // kUpperBorder, -0.8 m
    5.94,    // kUpperBorder, -0.3 m
    6.13,    // kUpperBorder, 0 m
    6.40,    // kUpperBorder, 0.3 m
    4.88,    // kUpperBorder, 0.6 m
    6.35,    // kUpperBorder, 1.2 m
    2.52,    // kLowerBorder, -0.8 m
    4.17,    // kLowerBorder, -0.3 m
    3.95,    // kLowerBorder, 0 m
    3.82,    // kLowerBorder, 0.3 m
    3.00,    // kLowerBorder, 0.6 m
    3.72,    // kLowerBorder, 1.2 m
    -0.50,   // kIsGround
    1.94,    // kLowStep
    0.13,    // kUnderLowBorder
    -0.14,   // kCovered
    -9.39,   // kMissing
    3.67,    // kFewPoints
    2.68,    // kLowerFewPoints
    1.00,    // kIsLedge
    -8.81,   // kStandBeside
    2.68,    // kStandIn
    1.94,    // kStandLower
    10.85,   // kIsMeeting
    -9.13,   // kMeetingOffset
    -2.53,   // kMeetingDirection
    -19.10,  // kMeetingMissing
    7.84,    // kMeetingFlat
    -0.96,   // kOneSideEmpty
    1.97,    // kShort
};
/// Weight of SurfaceHypothesis::accompanied.
inline constexpr double kAccompaniedWeight = 3.80;

/// Ratio of wrong to correct lines, divided by the range of heights that a wrong line may have.
inline constexpr double kWrongDensityPerMetre = 0.0020;
/// The largest distance of a surface for which the cloud has no plane from the next one for which
/// it has one: a hedge, a dormer's roof.
inline constexpr double kMaxObjectDistance_m = 1.8;

}  // namespace ridgeline::evaluate
