// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/outline.h"

#include "evaluate/faces/limits.h"
#include "tests/evaluate/faces/judged_building.h"

#include <gmock/gmock.h>

#include <cmath>

namespace ridgeline::test {
namespace {

using evaluate::EdgeOffset;
using evaluate::FacePoint;
using evaluate::NeighbourFace;
using evaluate::PlacedPoint;
using evaluate::PlaneFit;
using evaluate::PointPlace;
using evaluate::RoofFace;
using V = Eigen::Vector3d;

/// A level face at this height, from x = `from` to x = `to`, 10 m deep.
RoofFace level_strip(double from, double to, double z = 0.0) {
  return evaluate::make_roof_face("a",
                                  {{V(from, 0, z), V(to, 0, z), V(to, 10, z), V(from, 10, z)}});
}

PlaneFit fit_of(const Plane3& plane) {
  PlaneFit fit;
  fit.plane = plane;
  return fit;
}

const PlaneFit kLevel = fit_of(Plane3(V::UnitZ(), 0.0));

constexpr double kPointsPerM2 = 2.0;

/// One point every 5 cm across the edge at x = 10, from y = 2 to 8: on z = 0 up to `border`, below
/// that beyond.
std::vector<V> points_up_to(double border, double from = 8.0, double to = 12.0) {
  std::vector<V> points;
  for (int i = 0; from + 0.05 * i < to; ++i) {
    const double x = from + 0.05 * i + 0.02;
    const double y = 2.0 + 6.0 * std::fmod(0.618 * i, 1.0);
    points.emplace_back(x, y, x < border ? 0.0 : -3.0);
  }
  return points;
}

/// The offset of the edge of a face of 10 m x 10 m at x = 10.
EdgeOffset offset_by(const std::vector<V>& points, std::span<const NeighbourFace> neighbours = {}) {
  const RoofFace face = level_strip(0.0, 10.0);
  const evaluate::PointGrid grid = grid_of(points);
  const std::vector<FacePoint> around = points_around(grid, face, evaluate::kFaceReach_m);
  const std::vector<PlacedPoint> places = placed_points(around, face, kLevel, neighbours, {});
  const std::vector<EdgeOffset> edges = edge_offsets(around, places, face, kPointsPerM2);
  EXPECT_EQ(edges.size(), 1U);
  return edges.empty() ? EdgeOffset{} : edges.front();
}

TEST(EdgeOffsets, AreZeroWhereNoPointContradicts) {
  const EdgeOffset edge = offset_by(points_up_to(10.0));
  EXPECT_EQ(edge.offset_m, 0.0);
  EXPECT_EQ(edge.n_contradictions, 0);
  EXPECT_EQ(edge.edge, 1U);
}

TEST(EdgeOffsets, ArePositiveWhereTheFaceIsTooLarge) {
  const EdgeOffset edge = offset_by(points_up_to(9.5));
  EXPECT_NEAR(edge.offset_m, 0.5, 0.05);  // to the next point
  EXPECT_EQ(edge.n_contradictions, 9);    // expected in 9.5 m x 0.5 m
}

TEST(EdgeOffsets, AreNegativeWhereTheFaceIsTooSmall) {
  const EdgeOffset edge = offset_by(points_up_to(10.5));
  EXPECT_NEAR(edge.offset_m, -0.5, 0.05);
  EXPECT_EQ(edge.n_contradictions, 10);
}

TEST(EdgeOffsets, AreZeroWhereSlantingRaysPassUnderAnOverhang) {
  std::vector<V> points = points_up_to(10.0);
  for (double y = 2.0; y < 8.0; y += 0.1) {
    points.emplace_back(9.5, y, -1.0 - 0.3 * y);  // a wall
    points.emplace_back(9.8 - 0.05 * y, y, -4.0);
  }
  EXPECT_EQ(offset_by(points).offset_m, 0.0);
}

TEST(EdgeOffsets, FindAFaceTooLargeAlsoWithAWallBelow) {
  std::vector<V> points = points_up_to(9.5);
  for (double y = 2.0; y < 8.0; y += 0.1) points.emplace_back(9.2, y, -1.0 - 0.3 * y);
  EXPECT_NEAR(offset_by(points).offset_m, 0.5, 0.05);
}

TEST(EdgeOffsets, AreZeroWhereNoRayCameThrough) {
  std::vector<V> points = points_up_to(10.0);
  std::erase_if(points, [](const V& x) { return x.x() > 9.0 && x.x() < 10.0; });
  EXPECT_EQ(offset_by(points).offset_m, 0.0);
  for (double y = 2.0; y < 8.0; y += 0.1) points.emplace_back(9.5, y, 2.0);  // a tree
  EXPECT_EQ(offset_by(points).offset_m, 0.0);
}

TEST(EdgeOffsets, EndAtTheirReach) {
  EXPECT_NEAR(offset_by(points_up_to(20.0)).offset_m, -1.5, 0.05);
  EXPECT_NEAR(offset_by(points_up_to(0.0)).offset_m, 1.5, 0.05);
}

TEST(EdgeOffsets, AreNotMovedByAFewOddPoints) {
  std::vector<V> points = points_up_to(10.0);
  for (std::size_t i = 0; i < points.size(); i += 9)
    points[i].z() = points[i].z() == 0.0 ? 1.0 : 0.0;
  EXPECT_NEAR(offset_by(points).offset_m, 0.0, 0.11);
}

TEST(EdgeOffsets, AreNotMovedByWhatLiesBeyondACorner) {
  std::vector<V> points = points_up_to(10.0);
  for (int i = 0; i < 50; ++i) points.emplace_back(10.2 + 0.01 * i, 10.2 + 0.015 * i, 0.0);
  EXPECT_EQ(offset_by(points).offset_m, 0.0);
}

TEST(EdgeOffsets, TakeTheNearestOfSeveralPlaces) {
  // no points between 9.6 and 11: the face may end anywhere there
  std::vector<V> points = points_up_to(10.0);
  std::erase_if(points, [](const V& x) { return x.x() > 9.6 && x.x() < 11.0; });
  EXPECT_EQ(offset_by(points).offset_m, 0.0);
}

TEST(EdgeOffsets, AreNotMovedByOneOddPoint) {
  for (const double odd : {10.07, 9.92}) {
    std::vector<V> points = points_up_to(10.0);
    for (V& x : points) {
      if (std::abs(x.x() - odd) < 0.02) x.z() = odd > 10.0 ? 0.0 : -3.0;
    }
    EXPECT_NEAR(offset_by(points).offset_m, 0.0, 0.08) << odd;
    EXPECT_LE(offset_by(points).n_contradictions, 1) << odd;
  }
}

TEST(EdgeOffsets, LeaveOutEdgesWithFewPoints) {
  std::vector<V> points = points_up_to(10.0, 9.8, 10.2);
  ASSERT_EQ(points.size(), 8U);
  const RoofFace face = level_strip(0.0, 10.0);
  const evaluate::PointGrid grid = grid_of(points);
  const std::vector<FacePoint> around = points_around(grid, face, 1.5);
  const std::vector<PlacedPoint> places = placed_points(around, face, kLevel, {}, {});
  EXPECT_TRUE(edge_offsets(around, places, face, kPointsPerM2).empty());
}

TEST(PlacedPoints, OfAPlaneThatGoesOnInANeighbourSayNothing) {
  const RoofFace next = level_strip(10.0, 20.0);
  const NeighbourFace neighbour{&next, &kLevel};
  const std::vector<V> points = points_up_to(20.0, 8.6);  // within its reach
  const evaluate::PointGrid grid = grid_of(points);
  const RoofFace face = level_strip(0.0, 10.0);
  for (const PlacedPoint& point :
       placed_points(points_around(grid, face, 1.5), face, kLevel, std::span(&neighbour, 1), {})) {
    EXPECT_TRUE(point.explained);
    EXPECT_EQ(point.place, PointPlace::kUnknown);
  }
}

TEST(PlacedPoints, OverANeighbourWithoutAPlaneSayNothing) {
  const RoofFace next = level_strip(10.0, 20.0);
  const NeighbourFace neighbour{&next, nullptr};
  EXPECT_EQ(offset_by(points_up_to(20.0), std::span(&neighbour, 1)).offset_m, 0.0);
}

TEST(PlacedPoints, BelongToTheNearerOfTwoPlanesThatMeet) {
  // the neighbour's plane falls by 45 degrees from x = 10.4, where the outline should be
  const Plane3 falling(V(1, 0, 1).normalized(), V(10.4, 0, 0));
  const PlaneFit falling_fit = fit_of(falling);
  const RoofFace next = evaluate::make_roof_face(
      "b", {{V(10, 0, 0.4), V(14, 0, -3.6), V(14, 10, -3.6), V(10, 10, 0.4)}});
  std::vector<V> points = points_up_to(20.0);
  for (V& x : points) x.z() = std::min(0.0, 10.4 - x.x());
  const NeighbourFace neighbour{&next, &falling_fit};
  EXPECT_NEAR(offset_by(points, std::span(&neighbour, 1)).offset_m, -0.4, 0.051);
  // alone, the face would keep the points that lie less than 10 cm below its plane
  EXPECT_NEAR(offset_by(points).offset_m, -0.5, 0.051);
}

TEST(PlacedPoints, OnAFaceAboveAreNotMissing) {
  const RoofFace above = level_strip(4.0, 6.0, 2.0);
  const PlaneFit above_fit = fit_of(Plane3(V::UnitZ(), -2.0));
  const NeighbourFace neighbour{&above, &above_fit};
  std::vector<V> points{V(5, 5, 2.0), V(5, 4, 3.0), V(2, 5, 2.0)};
  const evaluate::PointGrid grid = grid_of(points);
  const RoofFace face = level_strip(0.0, 10.0);
  const std::vector<FacePoint> around = points_around(grid, face, 1.5);  // by x, then y
  const std::vector<PlacedPoint> places =
      placed_points(around, face, kLevel, std::span(&neighbour, 1), {});
  EXPECT_EQ(places[0].place, PointPlace::kAbove);  // beyond the neighbour's reach
  EXPECT_FALSE(places[0].explained);
  EXPECT_EQ(places[1].place, PointPlace::kAbove);  // a chimney on it
  EXPECT_FALSE(places[1].explained);
  EXPECT_EQ(places[2].place, PointPlace::kUnknown);
  EXPECT_TRUE(places[2].explained);
}

TEST(IsOutlineWrong, NeedsAnOffsetAndPoints) {
  const auto is_wrong = [](double offset_m, int n_contradictions) {
    const EdgeOffset edge{0, offset_m, n_contradictions};
    return is_outline_wrong(std::span(&edge, 1));
  };
  EXPECT_TRUE(is_wrong(0.31, 5));
  EXPECT_TRUE(is_wrong(-0.31, 5));
  EXPECT_FALSE(is_wrong(0.29, 50));
  EXPECT_FALSE(is_wrong(1.0, 4));
}

}  // namespace
}  // namespace ridgeline::test
