// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/bootstrap.h"
#include "reconstruct/geometry/segment.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::evaluate {

/// An edge of the scan is found if lines cover at least this share of its length together, and a
/// line follows the scan if edges do so.
inline constexpr double kFoundShare = 0.5;

/// An edge of the scan that lines should show. Local frame.
struct ExpectedEdge {
  Segment3 segment;
  std::string kind;  ///< see ScanEdge
  double length_m = 0.0;
  double support = 0.0;  ///< see ScanEdge
  double covered = 0.0;  ///< share of its length that has lines beside it, 0..1
  /// Whether at least two images show it. If not, it is counted apart. True if no images are known.
  bool is_shown = true;
  /// Names of its planes. The same plane has the same name wherever it is found in a frame.
  std::vector<std::uint64_t> planes;

  [[nodiscard]] bool is_found() const { return covered >= kFoundShare; }
};

/// The kinds of the rows, the last of which has the edges of all kinds.
inline constexpr std::array<std::string_view, 7> kEdgeKinds{"ridge", "hip",  "valley", "eave",
                                                            "verge", "step", "all"};

/// How many of the scan's edges of one kind and length lines have found.
struct CompletenessRow {
  std::string kind;    ///< see kEdgeKinds
  std::string length;  ///< "2-4", "4-8", "8+" (m) or all
  std::size_t n = 0, n_found = 0;
  std::size_t n_not_shown = 0;  ///< further edges, which fewer than two images show
  double length_m = 0.0, covered_m = 0.0;
  /// Of recall(): whole groups of connected planes are drawn, and Wilson's interval is the least.
  /// Empty for fewer than two groups.
  std::optional<Interval> ci95{};
  std::size_t n_clusters = 0;

  [[nodiscard]] std::optional<double> recall() const;            ///< empty without edges
  [[nodiscard]] std::optional<double> recall_by_length() const;  ///< covered_m / length_m
};

/// Which edges of the scan lines have found in an area.
struct Completeness {
  std::string area_from;  ///< the source of the area: stated, images, block or lines
  double area_m2 = 0.0;
  std::vector<ExpectedEdge> edges{};  ///< those that count, see compare_with_scan()
  std::size_t n_lines = 0;
  std::size_t n_without_edge = 0;  ///< lines that follow no edge of the scan; they may be right
  std::vector<CompletenessRow> rows{};  ///< see completeness_rows()
};

/// By kind, all of them last, and for each by length, all lengths first. Rows without edges are
/// left out. Edges that share a plane, directly or through other edges, are one cluster.
std::vector<CompletenessRow> completeness_rows(const std::vector<ExpectedEdge>& edges,
                                               const BootstrapOptions& options);

/// The row of a kind and length; null if there is none.
const CompletenessRow* find_row(const Completeness& completeness,
                                const std::string& kind,
                                const std::string& length = "all");

/// Completeness in several areas that do not overlap, as if it had been determined in all of them
/// at once. Throws std::invalid_argument without any.
Completeness pooled(const std::vector<const Completeness*>& parts, const BootstrapOptions& options);

}  // namespace ridgeline::evaluate
