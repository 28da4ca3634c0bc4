// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::evaluate {

/// Precision, recall and F1 of detected items, matched one to one.
struct DetectionScore {
  std::size_t n_found = 0, n_true = 0, n_matched = 0;

  [[nodiscard]] std::optional<double> precision() const;  ///< empty if n_found is 0
  [[nodiscard]] std::optional<double> recall() const;     ///< empty if n_true is 0
  [[nodiscard]] std::optional<double> f1() const;         ///< empty if n_found or n_true is 0
};

/// A set of lines treated as a wireframe, at one threshold.
struct WireframeScore {
  double threshold_m = 0.0;
  DetectionScore corners, edges;
  std::optional<double> mean_corner_offset_m;  ///< of the matched corners
};

inline constexpr double kWireframeThresholds_m[] = {0.1, 0.25, 0.5, 1.0};

/// The measures of Building3D (Wang et al. 2023), one score for each of kWireframeThresholds_m.
/// Corners are the ends of the lines; ends within a centimetre of each other are one corner.
/// Corners are matched one to one with true corners, nearest first, up to the threshold. An edge is
/// found if its two ends are matched with the ends of a true edge; a true edge counts once. Throws
/// std::invalid_argument for a segment that is not finite.
std::vector<WireframeScore> wireframe_scores(std::span<const Segment3> lines,
                                             std::span<const Segment3> references);

}  // namespace ridgeline::evaluate
