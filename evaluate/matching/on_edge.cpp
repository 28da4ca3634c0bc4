// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/matching/on_edge.h"

#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

constexpr double kMaxDistance_px = 2.0;  // between a segment and its edge, at both ends
constexpr double kMaxAngle_deg = 10.0;   // between the two: 2 px at both ends of the shortest
constexpr double kMinOverlap = 0.5;      // share of the shorter one that is alongside the other

/// Share of kMaxDistance_px up to which a segment certainly shows the edge. Shadows and gutters run
/// along edges at a distance of a few pixels.
constexpr double kCertain = 0.5;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool boxes_apart(const Segment2& a, const Segment2& b, double margin) {
  const auto apart = [&](double a0, double a1, double b0, double b1) {
    return std::max(a0, a1) + margin < std::min(b0, b1) ||
           std::max(b0, b1) + margin < std::min(a0, a1);
  };
  return apart(a.start.x(), a.end.x(), b.start.x(), b.end.x()) ||
         apart(a.start.y(), a.end.y(), b.start.y(), b.end.y());
}

}  // namespace

std::optional<Beside> lies_on(const Segment2& segment, const Segment2& edge) {
  if (boxes_apart(segment, edge, kMaxDistance_px)) return std::nullopt;
  const Eigen::Vector2d along = edge.end - edge.start;
  const double edge_length = along.norm();
  if (!(edge_length > 0.0) || !(length(segment) > 0.0)) return std::nullopt;
  const Eigen::Vector2d direction = segment.end - segment.start;
  if (acute_angle_rad(direction, along) > kMaxAngle_deg * kRadPerDeg) {
    return std::nullopt;
  }
  const auto parameter = [&](const Eigen::Vector2d& x) {
    return along.dot(x - edge.start) / (edge_length * edge_length);
  };
  const double t_start = parameter(segment.start);
  const double t_end = parameter(segment.end);
  const double from = std::max(0.0, std::min(t_start, t_end));
  const double to = std::min(1.0, std::max(t_start, t_end));
  const double shorter = std::min(1.0, std::abs(t_end - t_start));
  if (to - from < kMinOverlap * shorter) return std::nullopt;
  double distance_px = 0.0;
  for (const double t : {from, to}) {
    const double share = (t - t_start) / (t_end - t_start);
    const Eigen::Vector2d x = segment.start + share * direction;
    distance_px = std::max(distance_px, std::abs(cross(along, x - edge.start)) / edge_length);
  }
  if (distance_px > kMaxDistance_px) return std::nullopt;
  return Beside{0, from, to, distance_px};
}

bool continues(const Segment2& segment, const Segment2& edge) {
  const Eigen::Vector2d along = edge.end - edge.start;
  return lies_on(segment, {edge.start - along, edge.end + along}).has_value();
}

bool is_certain(const Beside& beside) { return beside.distance_px <= kCertain * kMaxDistance_px; }

}  // namespace ridgeline::evaluate
