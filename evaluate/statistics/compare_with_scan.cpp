// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/compare_with_scan.h"

#include "evaluate/statistics/parameter_intervals.h"
#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/splitmix64.h"
#include "reconstruct/geometry/transformed.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace ridgeline::evaluate {
namespace {

/// The share of a segment that has others within 0.3 m and 5 degrees.
double covered_by(const Segment3& segment,
                  std::span<const Segment3> others,
                  const BoxIndex3& index) {
  constexpr double kTolerance_m = 0.3;
  constexpr double kMaxAngle_rad = 5.0 * kRadPerDeg;
  const Eigen::Vector3d direction = segment.end - segment.start;
  std::vector<ParameterInterval> parts;
  for (const std::size_t i : index.near(segment, kTolerance_m)) {
    const Eigen::Vector3d other = others[i].end - others[i].start;
    if (other.isZero(0.0) || acute_angle_rad(direction, other) > kMaxAngle_rad) continue;
    if (const auto part = part_near(segment, others[i], kTolerance_m)) parts.push_back(*part);
  }
  return total_length(join(std::move(parts)));
}

std::vector<double> covered_shares(std::span<const Segment3> segments,
                                   std::span<const Segment3> others) {
  const BoxIndex3 index(others);
  std::vector<double> shares(segments.size());
  tbb::parallel_for(std::size_t{0}, segments.size(),
                    [&](std::size_t i) { shares[i] = covered_by(segments[i], others, index); });
  return shares;
}

/// A name that fits into the integers of a double.
std::uint64_t name_of(const ScanPlane& plane) {
  constexpr unsigned kSpareBits = 11;
  constexpr double kStepsPerMetre = 1000.0;
  std::uint64_t name = 0;
  for (const double x : plane.fit.centroid) {
    const auto steps = static_cast<std::uint64_t>(std::llround(x * kStepsPerMetre));
    name = SplitMix64::mix(name ^ steps);
  }
  return name >> kSpareBits;
}

bool is_expected(const ScanEdge& edge, const ScanScope& scope) {
  constexpr double kMinLength_m = 2.0;
  constexpr double kMinSupport = 0.8;
  return length(edge.segment) >= kMinLength_m && edge.support >= kMinSupport &&
         scope.contains(midpoint(edge.segment).head<2>());
}

std::vector<Segment3> with_length(std::span<const Segment3> segments, const char* what) {
  std::vector<Segment3> kept;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    check(all_finite(segments[i]), what, " ", i, ": coordinates must be finite");
    if (segments[i].start != segments[i].end) kept.push_back(segments[i]);
  }
  return kept;
}

}  // namespace

std::vector<ExpectedEdge> expected_edges(std::span<const Segment3> lines,
                                         const ScanEdges& scan,
                                         const ScanScope& scope) {
  std::vector<ExpectedEdge> edges;
  for (const ScanEdge& edge : scan.edges) {
    if (!is_expected(edge, scope)) continue;
    edges.push_back({.segment = edge.segment,
                     .kind = edge.kind,
                     .length_m = length(edge.segment),
                     .support = edge.support,
                     .is_shown = !scope.is_shown || scope.is_shown(edge.segment),
                     .planes = transformed(edge.planes, [&](std::size_t plane) {
                       return name_of(scan.planes[plane]);
                     })});
  }
  const std::vector<double> covered =
      covered_shares(transformed(edges, &ExpectedEdge::segment), with_length(lines, "line"));
  for (std::size_t i = 0; i < edges.size(); ++i) edges[i].covered = covered[i];
  return edges;
}

Completeness compare_with_scan(std::span<const Segment3> lines,
                               std::span<const Segment3> counted,
                               const ScanEdges& scan,
                               const ScanScope& scope,
                               const BootstrapOptions& options) {
  Completeness result{.area_from = scope.area_from, .area_m2 = scope.area_m2};
  result.edges = expected_edges(lines, scan, scope);
  const std::vector<double> covered = covered_shares(with_length(counted, "counted line"),
                                                     transformed(scan.edges, &ScanEdge::segment));
  result.n_lines = covered.size();
  result.n_without_edge = static_cast<std::size_t>(
      std::ranges::count_if(covered, [](double share) { return share < kFoundShare; }));
  result.rows = completeness_rows(result.edges, options);
  return result;
}

}  // namespace ridgeline::evaluate
