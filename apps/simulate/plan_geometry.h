// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::simulate {

/// f(x) = gradient . x + offset on the plan. It represents the height of an inclined plane, or a
/// half-plane f(x) >= 0.
struct PlanFunction {
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  double offset = 0.0;

  double operator()(const Eigen::Vector2d& x) const { return gradient.dot(x) + offset; }
};

inline PlanFunction operator-(const PlanFunction& a, const PlanFunction& b) {
  return {a.gradient - b.gradient, a.offset - b.offset};
}

/// The plane z = height(x, y), normal upwards.
Plane3 plane_of(const PlanFunction& height);

/// Corners of a convex polygon, counter-clockwise.
using ConvexPolygon = std::vector<Eigen::Vector2d>;

ConvexPolygon rectangle(const Eigen::Vector2d& low, const Eigen::Vector2d& high);

/// One function per side: the distance from that side in metres, >= 0 inside.
std::vector<PlanFunction> half_planes(const ConvexPolygon& polygon);

bool contains(const ConvexPolygon& polygon, const Eigen::Vector2d& x);

/// Whether the interiors of two convex polygons intersect (separating axis theorem).
bool overlap(const ConvexPolygon& a, const ConvexPolygon& b);

double area(const ConvexPolygon& polygon);

/// A convex polygon whose labels record the origin of each side: labels[i] belongs to the side from
/// corners[i] to corners[i + 1].
struct LabelledPolygon {
  ConvexPolygon corners;
  std::vector<int> labels;
};

/// The part of the polygon where inside >= 0; a new side gets `label`. Empty if nothing is left.
LabelledPolygon clip(const LabelledPolygon& polygon, const PlanFunction& inside, int label);
ConvexPolygon clip(const ConvexPolygon& polygon, std::span<const PlanFunction> inside);

/// A part of a segment, given by parameters t of point_at(segment, t); empty unless begin < end.
struct PlanInterval {
  double begin = 0.0;
  double end = 1.0;
  [[nodiscard]] bool empty() const { return !(begin < end); }
};

/// The part of the interval where inside >= 0 along the segment.
PlanInterval clip(PlanInterval interval, const Segment2& segment, const PlanFunction& inside);

/// The pieces of the intervals outside `hole`.
std::vector<PlanInterval> subtract(std::span<const PlanInterval> intervals,
                                   const PlanInterval& hole);

/// The segment within both polygons on which two heights agree; std::nullopt for parallel planes.
std::optional<Segment2> intersection(const PlanFunction& height_a,
                                     const ConvexPolygon& polygon_a,
                                     const PlanFunction& height_b,
                                     const ConvexPolygon& polygon_b);

}  // namespace ridgeline::simulate
