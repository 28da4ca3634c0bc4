// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/edge_appearance.h"
#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/epipolar_overlap.h"

#include <array>
#include <optional>

namespace ridgeline::reconstruct {

/// Similarity of the colours next to a line, on the side that changes less, because the other side
/// may change by occlusion.
std::optional<double> colour_similarity(const EdgePair& edges, const Radiometry& radiometry);

/// Similarity of the colour steps c and c' across the line in direction and size: 1 - |c - c'| /
/// (|c| + |c'|). std::nullopt if neither image has a step.
std::optional<double> contrast_similarity(const EdgePair& edges, const Radiometry& radiometry);

/// The evidence for a match of two individual lines; each measure is in [0, 1], where 1 is best.
struct LineMeasures {
  enum Index : int {
    kBetterSide,    ///< correlation of the side that agrees better
    kOtherSide,     ///< correlation of the other side; 0.5 (undecided) if it is not visible
    kBetterColour,  ///< agreement of the mean colours on the side that agrees better
    kOtherColour,
    kContrast,  ///< direction and strength of the colour step across the line
    kProfile,   ///< correlation of the profiles across the line
    kOverlap,   ///< share of the shorter segment in the epipolar overlap
    kEnds,      ///< closeness of both ends to their counterparts
    kCount
  };
  std::array<double, kCount> values{};
};

LineMeasures line_measures(const EdgePair& edges,
                           const EdgeAppearance& appearance,
                           const Radiometry& radiometry);

/// Probability of the match in [0, 1] by logistic regression over the measures. The regression is
/// fitted to the candidates of the simulated training scenes (seeds 1 to 8), whose surfaces show
/// which candidates are correct.
double line_similarity(const LineMeasures& measures);

}  // namespace ridgeline::reconstruct
