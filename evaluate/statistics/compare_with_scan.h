// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/scan_edges.h"
#include "evaluate/statistics/completeness.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// Where the edges of a scan are expected.
struct ScanScope {
  std::string area_from{};  ///< see Completeness
  double area_m2 = 0.0;
  std::function<bool(const Eigen::Vector2d&)> contains;  ///< a place in plan, local
  /// Whether at least two images show a segment; empty if no images are known.
  std::function<bool(const Segment3&)> is_shown = {};
};

/// The edges of a scan that lines should show, and how much of each they cover. An edge counts if
/// it is at least 2 m long, has a support of at least 0.8, and its middle lies in the scope. It is
/// covered where lines within 5 degrees of its direction lie within 0.3 m. `lines`: also outside
/// the scope; local frame. Segments of zero length are ignored. Throws std::invalid_argument for a
/// line that is not finite.
std::vector<ExpectedEdge> expected_edges(std::span<const Segment3> lines,
                                         const ScanEdges& scan,
                                         const ScanScope& scope);

/// Which of the expected_edges() lines have found, and which lines follow edges of the scan: those
/// that are covered over half of their length by edges of any length and support.
/// @param counted  the lines that are counted with and without an edge
/// Throws like expected_edges().
Completeness compare_with_scan(std::span<const Segment3> lines,
                               std::span<const Segment3> counted,
                               const ScanEdges& scan,
                               const ScanScope& scope,
                               const BootstrapOptions& options);

}  // namespace ridgeline::evaluate
