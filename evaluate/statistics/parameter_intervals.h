// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"

#include <optional>
#include <vector>

namespace ridgeline::evaluate {

/// Part of a segment, given by its parameter: 0 <= begin <= end <= 1.
struct ParameterInterval {
  double begin = 0.0;
  double end = 0.0;
};

/// The intervals in ascending order, with overlapping and touching ones joined.
std::vector<ParameterInterval> join(std::vector<ParameterInterval> intervals);

/// Sum of the lengths of disjoint intervals.
double total_length(const std::vector<ParameterInterval>& disjoint);

/// Number of the parameters (k + 0.5) / n, k = 0 .. n - 1, that lie in disjoint intervals.
int count_samples(const std::vector<ParameterInterval>& disjoint, int n);

/// The parameters at which a linear function from `start` to `end` has a magnitude of at most
/// `limit`; empty if there are none.
std::optional<ParameterInterval> where_within(double start, double end, double limit);

/// The part of `segment` within `tolerance` of the segment `reference` (not of the line beyond its
/// ends). It is a single interval, because the distance to a convex set is convex along a line. The
/// solution is exact: three quadratics are solved, for the parts nearest to the start, the interior
/// and the end of the reference.
std::optional<ParameterInterval> part_near(const Segment3& segment,
                                           const Segment3& reference,
                                           double tolerance);

}  // namespace ridgeline::evaluate
