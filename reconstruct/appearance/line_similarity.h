// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/edge_appearance.h"
#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/epipolar_overlap.h"

#include <array>
#include <optional>

namespace ridgeline::reconstruct {

/// How alike the colours beside a line are, on the side that changes less, because occlusion
/// changes the other one.
std::optional<double> colour_similarity(const EdgePair& edges, const Radiometry& radiometry);

/// How alike the colour steps c and c' across the line are in direction and size: 1 - |c - c'| /
/// (|c| + |c'|). Absent if neither image has a step.
std::optional<double> contrast_similarity(const EdgePair& edges, const Radiometry& radiometry);

/// The evidence for a match of two single lines, each measure in [0, 1] with 1 as the best.
struct LineMeasures {
  enum Index : int {
    kBetterSide,    ///< correlation of the side that agrees better
    kOtherSide,     ///< correlation of the other side; 0.5, undecided, if it is not seen
    kBetterColour,  ///< agreement of the mean colours on the side that agrees better
    kOtherColour,
    kContrast,  ///< direction and strength of the colour step across the line
    kProfile,   ///< correlation of the profiles across the line
    kOverlap,   ///< share of the shorter segment in the epipolar overlap
    kEnds,      ///< how close both ends come to their counterparts
    kCount
  };
  std::array<double, kCount> values{};
};

LineMeasures line_measures(const EdgePair& edges,
                           const EdgeAppearance& appearance,
                           const Radiometry& radiometry);

/// Probability of the match in [0, 1] by logistic regression over the measures. The regression is
/// fitted to the candidates of the simulated training scenes (seeds 1 to 8), of which the simulated
/// surfaces tell the right ones.
double line_similarity(const LineMeasures& measures);

}  // namespace ridgeline::reconstruct
