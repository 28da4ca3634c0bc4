// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/completeness.h"

#include "evaluate/statistics/distribution.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <string_view>

namespace ridgeline::evaluate {
namespace {

constexpr std::string_view kAnyKind = kExpectedKinds.back();

struct LengthClass {
  const char* name;
  double from_m, to_m;  ///< without its end
};
constexpr std::array kLengthClasses{
    LengthClass{"all", 0.0, std::numeric_limits<double>::infinity()}, LengthClass{"2-4", 0.0, 4.0},
    LengthClass{"4-8", 4.0, 8.0}, LengthClass{"8+", 8.0, std::numeric_limits<double>::infinity()}};

std::optional<double> part_of_whole(double part, double whole) {
  return whole > 0.0 ? std::optional(part / whole) : std::nullopt;
}

/// The group of connected planes to which each edge belongs.
std::vector<std::size_t> clusters_of(const std::vector<ExpectedEdge>& edges) {
  DisjointSets sets(edges.size());
  std::map<std::uint64_t, std::size_t> first_of_plane;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (const std::uint64_t plane : edges[i].planes)
      sets.join(i, first_of_plane.try_emplace(plane, i).first->second);
  }
  std::vector<std::size_t> clusters(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) clusters[i] = sets.name_of(i);
  return clusters;
}

struct EdgeCluster {
  double n = 0.0, n_found = 0.0;
  auto operator<=>(const EdgeCluster&) const = default;
};

std::optional<Interval> recall_interval(const CompletenessRow& row,
                                        std::vector<EdgeCluster> clusters,
                                        const BootstrapOptions& options) {
  std::ranges::sort(clusters);  // the interval must not depend on the order of the edges
  const auto recall = [&](std::span<const std::size_t> drawn) {
    EdgeCluster sum;
    for (const std::size_t i : drawn) {
      sum.n += clusters[i].n;
      sum.n_found += clusters[i].n_found;
    }
    return sum.n_found / sum.n;
  };
  const auto drawn = clustered_bootstrap(clusters.size(), recall, options);
  const auto least = wilson_interval(row.n_found, row.n, options.level);
  if (!drawn || !least) return std::nullopt;
  return Interval{std::min(drawn->low, least->low), std::max(drawn->high, least->high)};
}

CompletenessRow completeness_row(const std::vector<ExpectedEdge>& edges,
                                 const std::vector<std::size_t>& clusters,
                                 std::string_view kind,
                                 const LengthClass& of_length,
                                 const BootstrapOptions& options) {
  CompletenessRow row{.kind = std::string(kind), .length = of_length.name};
  CompensatedSum length_m, covered_m;
  std::map<std::size_t, EdgeCluster> sums;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const ExpectedEdge& edge = edges[i];
    if (kind != kAnyKind && edge.kind != kind) continue;
    if (edge.length_m < of_length.from_m || edge.length_m >= of_length.to_m) continue;
    if (!edge.is_shown) {
      ++row.n_not_shown;
      continue;
    }
    ++row.n;
    row.n_found += edge.is_found() ? 1 : 0;
    length_m.add(edge.length_m);
    covered_m.add(edge.length_m * edge.covered);
    EdgeCluster& cluster = sums[clusters[i]];
    cluster.n += 1.0;
    cluster.n_found += edge.is_found() ? 1.0 : 0.0;
  }
  row.length_m = length_m.value();
  row.covered_m = covered_m.value();
  row.n_clusters = sums.size();
  std::vector<EdgeCluster> of_row;
  of_row.reserve(sums.size());
  for (const auto& [name, cluster] : sums) of_row.push_back(cluster);
  row.ci95 = recall_interval(row, std::move(of_row), options);
  return row;
}

}  // namespace

std::optional<double> CompletenessRow::recall() const {
  return part_of_whole(static_cast<double>(n_found), static_cast<double>(n));
}

std::optional<double> CompletenessRow::recall_by_length() const {
  return part_of_whole(covered_m, length_m);
}

std::vector<CompletenessRow> completeness_rows(const std::vector<ExpectedEdge>& edges,
                                               const BootstrapOptions& options) {
  const std::vector<std::size_t> clusters = clusters_of(edges);
  std::vector<CompletenessRow> rows;
  for (const std::string_view kind : kExpectedKinds) {
    for (const LengthClass& of_length : kLengthClasses) {
      CompletenessRow row = completeness_row(edges, clusters, kind, of_length, options);
      if (row.n + row.n_not_shown > 0) rows.push_back(std::move(row));
    }
  }
  return rows;
}

const CompletenessRow* find_row(const Completeness& completeness,
                                const std::string& kind,
                                const std::string& length) {
  const auto found = std::ranges::find_if(completeness.rows, [&](const CompletenessRow& row) {
    return row.kind == kind && row.length == length;
  });
  return found == completeness.rows.end() ? nullptr : &*found;
}

Completeness pooled(const std::vector<const Completeness*>& parts,
                    const BootstrapOptions& options) {
  check(!parts.empty(), "pooled: no completeness; must be at least one");
  Completeness all{.area_from = parts.front()->area_from};
  for (const Completeness* part : parts) {
    all.area_m2 += part->area_m2;
    all.n_lines += part->n_lines;
    all.n_without_edge += part->n_without_edge;
    all.edges.insert(all.edges.end(), part->edges.begin(), part->edges.end());
  }
  all.rows = completeness_rows(all.edges, options);
  return all;
}

}  // namespace ridgeline::evaluate
