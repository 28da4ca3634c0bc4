// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/compare/pair_in_space.h"

#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>

namespace ridgeline::evaluate {
namespace {

/// The distance between two segments where they run side by side; std::nullopt unless they may show
/// the same line.
std::optional<double> gap_m(const Segment3& a, const Segment3& b) {
  const Eigen::Vector3d along = a.end - a.start;
  const Eigen::Vector3d across = b.end - b.start;
  const double length_a = along.norm();
  const double length_b = across.norm();
  if (!(length_a > 0.0) || !(length_b > 0.0)) return std::nullopt;
  const double cosine = std::abs(along.dot(across)) / (length_a * length_b);
  if (cosine < std::cos(kMaxPairAngle_deg * kRadPerDeg)) return std::nullopt;
  const double t_start = along.dot(b.start - a.start) / (length_a * length_a);
  const double t_end = along.dot(b.end - a.start) / (length_a * length_a);
  const double from = std::max(0.0, std::min(t_start, t_end));
  const double to = std::min(1.0, std::max(t_start, t_end));
  const double shorter = std::min(1.0, std::abs(t_end - t_start));
  if (to - from < kMinPairOverlap * shorter) return std::nullopt;
  double largest_m = 0.0;
  for (const double t : {from, to}) {
    const Eigen::Vector3d on_b = b.start + (t - t_start) / (t_end - t_start) * across;
    largest_m = std::max(largest_m, (a.start + t * along - on_b).norm());
  }
  return largest_m <= kMaxPairDistance_m ? std::optional(largest_m) : std::nullopt;
}

/// Two segments that may be a pair.
struct PossiblePair {
  std::size_t a, b;
  double gap_m;
};

/// Groups of candidates that share segments, directly or through others, in the order of their
/// first candidates.
std::vector<std::vector<PossiblePair>> groups_of(const std::vector<PossiblePair>& candidates,
                                                 std::size_t n_a,
                                                 std::size_t n_b) {
  std::vector<std::size_t> parent(n_a + n_b);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const PossiblePair& c : candidates) parent[root(c.a)] = root(n_a + c.b);
  std::map<std::size_t, std::size_t> group_of;
  std::vector<std::vector<PossiblePair>> groups;
  for (const PossiblePair& c : candidates) {
    const auto [group, is_new] = group_of.try_emplace(root(c.a), groups.size());
    if (is_new) groups.emplace_back();
    groups[group->second].push_back(c);
  }
  return groups;
}

/// Assigns a different column to each row so that the sum of costs is smallest, using the Hungarian
/// method with potentials (Kuhn 1955; Jonker and Volgenant 1987). There must not be more rows than
/// columns. Returns the column of each row.
std::vector<std::size_t> cheapest_columns(const Eigen::MatrixXd& costs) {
  const auto n = static_cast<std::size_t>(costs.rows()), m = static_cast<std::size_t>(costs.cols());
  // row and column 0 stand for "none"
  std::vector<double> of_row(n + 1, 0.0), of_column(m + 1, 0.0);
  std::vector<std::size_t> row_of(m + 1, 0), before(m + 1, 0);
  for (std::size_t row = 1; row <= n; ++row) {
    std::vector<double> slack(m + 1, HUGE_VAL);
    std::vector<bool> is_done(m + 1, false);
    row_of[0] = row;
    std::size_t column = 0;
    while (row_of[column] != 0) {
      is_done[column] = true;
      const std::size_t i = row_of[column];
      std::size_t next = 0;
      for (std::size_t k = 1; k <= m; ++k) {
        if (is_done[k]) continue;
        const double reduced =
            costs(static_cast<Eigen::Index>(i - 1), static_cast<Eigen::Index>(k - 1)) - of_row[i] -
            of_column[k];
        if (reduced < slack[k]) slack[k] = reduced, before[k] = column;
        if (next == 0 || slack[k] < slack[next]) next = k;
      }
      const double step = slack[next];
      for (std::size_t k = 0; k <= m; ++k) {
        if (is_done[k]) {
          of_row[row_of[k]] += step;
          of_column[k] -= step;
        } else {
          slack[k] -= step;
        }
      }
      column = next;
    }
    for (; column != 0; column = before[column]) row_of[column] = row_of[before[column]];
  }
  std::vector<std::size_t> columns(n);
  for (std::size_t k = 1; k <= m; ++k)
    if (row_of[k] != 0) columns[row_of[k] - 1] = k - 1;
  return columns;
}

/// Pairs the closest segments of a group first, each segment once.
std::vector<std::pair<std::size_t, std::size_t>> nearest_first(std::vector<PossiblePair> group) {
  std::ranges::sort(group, {}, [](const PossiblePair& c) { return std::tuple(c.gap_m, c.a, c.b); });
  std::set<std::size_t> taken_a, taken_b;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const PossiblePair& c : group) {
    if (taken_a.contains(c.a) || taken_b.contains(c.b)) continue;
    taken_a.insert(c.a);
    taken_b.insert(c.b);
    pairs.emplace_back(c.a, c.b);
  }
  return pairs;
}

/// The pairs of a group with the smallest sum of gaps, with kMaxPairDistance_m for a segment of `a`
/// without a partner.
std::vector<std::pair<std::size_t, std::size_t>> assignment(
    const std::vector<PossiblePair>& group) {
  if (group.size() == 1) return {{group[0].a, group[0].b}};
  std::map<std::size_t, Eigen::Index> rows, columns;
  for (const PossiblePair& c : group) {
    rows.try_emplace(c.a, static_cast<Eigen::Index>(rows.size()));
    columns.try_emplace(c.b, static_cast<Eigen::Index>(columns.size()));
  }
  const auto n = static_cast<Eigen::Index>(rows.size()),
             m = static_cast<Eigen::Index>(columns.size());
  constexpr double kMaxCells = 1e6;
  if (static_cast<double>(n) * static_cast<double>(n + m) > kMaxCells) return nearest_first(group);
  constexpr double kNever = 1e6;
  Eigen::MatrixXd costs = Eigen::MatrixXd::Constant(n, m + n, kNever);
  costs.rightCols(n).setConstant(kMaxPairDistance_m);
  for (const PossiblePair& c : group) costs(rows[c.a], columns[c.b]) = c.gap_m;
  const std::vector<std::size_t> chosen = cheapest_columns(costs);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& [a, row] : rows) {
    for (const auto& [b, column] : columns) {
      if (static_cast<Eigen::Index>(chosen[static_cast<std::size_t>(row)]) == column)
        pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

Eigen::AlignedBox2d plan_box(const Segment3& s) { return plan_box_of(std::array{s.start, s.end}); }

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> pair_in_space(std::span<const Segment3> a,
                                                               std::span<const Segment3> b) {
  const BoxIndex2 index(transformed(b, plan_box));
  std::vector<PossiblePair> candidates;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const std::size_t k : index.near(plan_box(a[i]), kMaxPairDistance_m)) {
      if (const std::optional<double> gap = gap_m(a[i], b[k])) candidates.push_back({i, k, *gap});
    }
  }
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const std::vector<PossiblePair>& group : groups_of(candidates, a.size(), b.size())) {
    std::ranges::copy(assignment(group), std::back_inserter(pairs));
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace ridgeline::evaluate
