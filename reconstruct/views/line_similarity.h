// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/views/edge_look.h"
#include "reconstruct/views/epipolar_overlap.h"

#include <array>
#include <optional>

namespace ridgeline::reconstruct {

/// How alike the colours beside a line are: of the side that changes less, since occlusion changes the other.
std::optional<double> colour_similarity(const EdgePair& edges, const Radiometry& radiometry);

/// How alike the colour step across one line, direction and size: 1 - |c - c'| / (|c| + |c'|). Absent
/// without a step in both images.
std::optional<double> contrast_similarity(const EdgePair& edges, const Radiometry& radiometry);

/// What speaks for a match of two single lines, each in [0, 1] with 1 as the best.
struct LineMeasures {
  enum Index : int {
    kBetterSide,    ///< correlation of the side that agrees better
    kOtherSide,     ///< of the other side; 0.5, undecided, where it is not seen
    kBetterColour,  ///< mean colour of the side that agrees better
    kOtherColour,
    kContrast,  ///< direction and strength of the colour step across the line
    kProfile,   ///< correlation of the profiles across the line
    kOverlap,   ///< share of the shorter segment in the epipolar overlap
    kEnds,      ///< how close both ends come to their mates
    kCount
  };
  std::array<double, kCount> values{};
};

LineMeasures line_measures(const EdgePair& edges,
                           const EdgeLook& look,
                           const Radiometry& radiometry);

/// Probability of the match in [0, 1] by logistic regression over the measures, fitted to the
/// candidates of the simulated training scenes (seeds 1 to 8) that the surfaces themselves judge.
double line_similarity(const LineMeasures& measures);

}  // namespace ridgeline::reconstruct
