// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/scan/scan_edges.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// The edges of one kind.
struct EdgesOfKind {
  std::string kind;  ///< as in ScanEdge, or "total"
  std::size_t n = 0;
  double length_m = 0.0;        ///< of all together
  double median_sigma_m = 0.0;  ///< of across_sigma_m(); 0 without edges
};

/// Standard deviation of the middle of an edge at right angles to it: the root of the sum of both
/// variances.
double across_sigma_m(const ScanEdge& edge);

/// A row for each kind, in the order ridge, hip, valley, eave, verge, step, also for those without
/// edges; then the total.
std::vector<EdgesOfKind> by_kind(std::span<const ScanEdge> edges);

}  // namespace ridgeline::evaluate
