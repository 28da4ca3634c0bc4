// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/face_plane.h"

#include "tests/evaluate/faces/judged_building.h"

#include <gmock/gmock.h>

#include <cmath>

namespace ridgeline::test {
namespace {

using evaluate::FacePoint;
using evaluate::PlaneFit;
using evaluate::RoofFace;
using V = Eigen::Vector3d;

/// A level face of 10 m x 10 m at z = 0.
RoofFace level_face() {
  return evaluate::make_roof_face("a", {{V(0, 0, 0), V(10, 0, 0), V(10, 10, 0), V(0, 10, 0)}});
}

/// 100 points a plane over the face at x < `end`.
void add_points(std::vector<V>& points, const Plane3& plane, double end, double sigma_m) {
  Random random(points.size() + 1);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector2d x(random.uniform(0.0, end), random.uniform(0.0, 10.0));
    points.emplace_back(x.x(), x.y(), height_at(plane, x) + random.normal(sigma_m));
  }
}

std::optional<PlaneFit> found_in(const std::vector<V>& points) {
  const evaluate::PointGrid grid = grid_of(points);
  return find_face_plane(points_around(grid, level_face(), 0.0), level_face(), {});
}

Plane3 tilted(double angle_deg, double height_m) {
  const double angle_rad = angle_deg * kRadPerDeg;
  return Plane3(V(std::sin(angle_rad), 0.0, std::cos(angle_rad)), V(5.0, 5.0, height_m));
}

TEST(PointsAround, FindsWhatASearchOfAllFinds) {
  Random random(6);
  std::vector<V> points;
  for (int i = 0; i < 2000; ++i) points.push_back(random.vector(-15.0, 15.0));
  const evaluate::PointGrid grid = grid_of(points);
  for (const auto& [x, y] : {std::pair(9.0, 1.0), {1.0, 9.0}, {6.0, 6.0}}) {
    const RoofFace face =
        evaluate::make_roof_face("a", {{V(-x, -y, 0), V(x, -y, 0), V(x, y, 0), V(-x, y, 0)}});
    std::vector<FacePoint> found = points_around(grid, face, 3.0);
    std::size_t n_expected = 0;
    for (const V& p : points) n_expected += face.plan.distance_m(p.head<2>()) <= 3.0 ? 1 : 0;
    EXPECT_EQ(found.size(), n_expected);
    for (const FacePoint& p : found) {
      const bool inside = std::abs(p.point.x.x()) < x && std::abs(p.point.x.y()) < y;
      EXPECT_EQ(p.beyond_m < 0.0, inside);
      EXPECT_LE(p.beyond_m, 3.0);
      EXPECT_EQ(p.point.x, points[p.point.index]);
    }
  }
}

TEST(FindFacePlane, TakesThePlaneThatIsLikeTheFaces) {
  for (const auto& [angle_deg, height_m] :
       {std::pair(0.0, 0.0), {14.0, 0.0}, {0.0, -1.9}, {-14.0, 1.9}}) {
    std::vector<V> points;
    add_points(points, tilted(angle_deg, height_m), 10.0, 0.0);
    add_points(points, tilted(0.0, -6.0), 10.0, 0.0);  // as many of the ground
    add_points(points, tilted(40.0, 9.0), 10.0, 0.0);
    const std::optional<PlaneFit> fit = found_in(points);
    ASSERT_TRUE(fit) << angle_deg;
    EXPECT_TRUE(fit->plane.isApprox(tilted(angle_deg, height_m), 1e-9)) << angle_deg;
  }
}

TEST(FindFacePlane, FindsNothingThatIsUnlikeTheFace) {
  for (const auto& [angle_deg, height_m] : {std::pair(16.0, 0.0), {0.0, 2.1}, {0.0, -2.1}}) {
    std::vector<V> points;
    add_points(points, tilted(angle_deg, height_m), 10.0, 0.0);
    EXPECT_FALSE(found_in(points)) << angle_deg << " " << height_m;
  }
}

TEST(FindFacePlane, FindsNothingInARowOfPointsWithoutAMessageOfPcl) {
  std::vector<V> points;
  for (int i = 0; i < 60; ++i) points.emplace_back(0.5 + 0.15 * i, 5.0, 0.0);
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE(found_in(points));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(FindFacePlane, TakesTheLargestOfSeveral) {
  std::vector<V> points;
  add_points(points, tilted(0.0, 0.0), 4.0, 0.0);
  add_points(points, tilted(0.0, 1.0), 10.0, 0.0);
  add_points(points, tilted(0.0, 1.0), 10.0, 0.0);
  EXPECT_NEAR(found_in(points)->plane.offset(), -1.0, 1e-9);
}

TEST(FindFacePlane, LeavesOutPointsNearTheOutline) {
  std::vector<V> points;
  add_points(points, tilted(0.0, 0.0), 10.0, 0.0);
  for (int i = 0; i < 30; ++i) points.emplace_back(0.1, 0.3 * i, 0.09);
  EXPECT_NEAR(found_in(points)->plane.offset(), 0.0, 1e-9);
}

TEST(FindFacePlane, LooksAtAllPartsOfVeryManyPoints) {
  // nearly half of the face belongs to another surface
  std::vector<V> points;
  for (int i = 0; i < 60; ++i) add_points(points, tilted(0.0, 0.5), 10.0, 0.03);
  for (V& x : points) x.z() += x.x() < 4.5 ? 1.0 : 0.0;
  const std::optional<PlaneFit> fit = found_in(points);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->plane.offset(), -0.5, 0.01);
  EXPECT_GT(fit->n, 2800);
}

TEST(RefitFacePlane, LeavesOutWhatMayBeANeighbours) {
  // the points over the face lie on two planes that meet at x = 9
  const Plane3 own(V::UnitZ(), V::Zero());
  const Plane3 other = tilted(30.0, 4.0 * std::tan(30.0 * kRadPerDeg));
  std::vector<V> points;
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d x(random.uniform(0.0, 10.0), random.uniform(0.0, 10.0));
    points.emplace_back(x.x(), x.y(), std::min(0.0, height_at(other, x)));
  }
  const evaluate::PointGrid grid = grid_of(points);
  const RoofFace face = level_face();
  const std::vector<FacePoint> around = points_around(grid, face, 0.0);
  const std::optional<PlaneFit> fit = find_face_plane(around, face, {});
  ASSERT_TRUE(fit);
  EXPECT_GT((fit->plane.normal() - own.normal()).norm(), 1e-5);
  const RoofFace beyond = evaluate::make_roof_face(
      "b", {{V(10, 0, -0.5), V(14, 0, -3), V(14, 10, -3), V(10, 10, -0.5)}});
  PlaneFit fit_beyond;
  fit_beyond.plane = other;
  const evaluate::NeighbourFace neighbour{&beyond, &fit_beyond};
  const PlaneFit refitted = refit_face_plane(around, *fit, std::span(&neighbour, 1), {});
  EXPECT_TRUE(refitted.plane.isApprox(own, 1e-9));
  EXPECT_LT(refitted.n, fit->n);
}

TEST(UntruncatedSigma, IsThatOfTheWholeDistribution) {
  // k = 2 and k = 3: g = 0.77374, 0.97334 (tables of the truncated normal distribution)
  EXPECT_NEAR(evaluate::untruncated_sigma_m(std::sqrt(0.773741), 2.0), 1.0 / std::sqrt(0.773741),
              1e-5);
  EXPECT_NEAR(evaluate::untruncated_sigma_m(std::sqrt(0.973337), 3.0), 1.0 / std::sqrt(0.973337),
              1e-5);
  EXPECT_NEAR(evaluate::untruncated_sigma_m(0.01, 0.1), 0.01, 1e-9);  // nothing is cut off
  EXPECT_EQ(evaluate::untruncated_sigma_m(0.0, 0.1), 0.0);
  EXPECT_NEAR(evaluate::untruncated_sigma_m(0.09, 0.1) / 0.09, 1.0 / 0.551524, 1e-5);  // k = 1.5
}

}  // namespace
}  // namespace ridgeline::test
