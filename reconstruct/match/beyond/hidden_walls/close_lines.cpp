// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/hidden_walls/close_lines.h"

#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace ridgeline::reconstruct {
namespace {

constexpr double kClose_px = 4.5;
constexpr double kParallel_deg = 8.0;
constexpr double kMinOverlap = 0.6;   // share of the shorter line
constexpr double kMinCoverage = 0.5;  // share of the line; a fragment beside it proves little

/// Signed distance of b from a, in the middle of their common part; empty if b does not run along
/// a.
std::optional<double> offset_px(const Segment2& a, const Segment2& b) {
  if (acute_angle_rad(a, b) > kParallel_deg * kRadPerDeg) return std::nullopt;
  const double len = length(a);
  const double start = along(a).dot(b.start - a.start);
  const double end = along(a).dot(b.end - a.start);
  const double low = std::max(0.0, std::min(start, end));
  const double high = std::min(len, std::max(start, end));
  const double least_px =
      std::max(kMinOverlap * std::min(len, std::abs(end - start)), kMinCoverage * len);
  if (high - low < least_px) return std::nullopt;
  const double share = (0.5 * (low + high) - start) / (end - start);
  const double offset = normal(a).dot(point_at(b, share) - a.start);
  if (std::abs(offset) > kClose_px) return std::nullopt;
  return offset;
}

std::vector<CloseLine> close_lines_of(const BoxIndex2& index,
                                      std::span<const Segment2> segments,
                                      std::size_t id) {
  const Segment2& a = segments[id];
  const Eigen::Vector2d n = normal(a);
  std::array<std::optional<CloseLine>, 2> nearest;
  std::array<double, 2> distance{std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::infinity()};
  for (const std::size_t other : index.near(a, kClose_px)) {
    if (other == id) continue;
    const auto offset = offset_px(a, segments[other]);
    if (!offset) continue;
    const std::size_t side = *offset < 0.0 ? 0 : 1;
    if (std::abs(*offset) >= distance[side]) continue;
    distance[side] = std::abs(*offset);
    nearest[side] =
        CloseLine{static_cast<int>(other), side == 0 ? Eigen::Vector2d(-n) : n, distance[side]};
  }
  std::vector<CloseLine> found;
  for (const auto& line : nearest) {
    if (line) found.push_back(*line);
  }
  return found;
}

}  // namespace

CloseLines close_lines(std::span<const Segment2> segments) {
  const BoxIndex2 index(segments);
  CloseLines found(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    found[i] = close_lines_of(index, segments, i);
  }
  return found;
}

}  // namespace ridgeline::reconstruct
