// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/compare/pair_in_space.h"

#include "reconstruct/geometry/degrees.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

namespace ridgeline::evaluate {
namespace {

/// How far apart two segments are where they run side by side; nothing unless they are of one line.
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

double lowest_x(const Segment3& s) { return std::min(s.start.x(), s.end.x()); }
double highest_x(const Segment3& s) { return std::max(s.start.x(), s.end.x()); }

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> pair_in_space(std::span<const Segment3> a,
                                                               std::span<const Segment3> b) {
  std::vector<std::size_t> by_x(b.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::ranges::stable_sort(by_x, {}, [&](std::size_t k) { return lowest_x(b[k]); });
  std::vector<std::tuple<double, std::size_t, std::size_t>> candidates;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const std::size_t k : by_x) {
      if (lowest_x(b[k]) > highest_x(a[i]) + kMaxPairDistance_m) break;
      if (highest_x(b[k]) < lowest_x(a[i]) - kMaxPairDistance_m) continue;
      if (const std::optional<double> gap = gap_m(a[i], b[k])) candidates.emplace_back(*gap, i, k);
    }
  }
  std::ranges::sort(candidates);
  std::vector<char> is_taken_a(a.size(), 0);
  std::vector<char> is_taken_b(b.size(), 0);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const auto& candidate : candidates) {
    const std::size_t i = std::get<1>(candidate);
    const std::size_t k = std::get<2>(candidate);
    if (is_taken_a[i] != 0 || is_taken_b[k] != 0) continue;
    is_taken_a[i] = is_taken_b[k] = 1;
    pairs.emplace_back(i, k);
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace ridgeline::evaluate
