// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/point_distances.h"

#include "tests/evaluate/faces/judged_building.h"

#include <gmock/gmock.h>

namespace ridgeline::test {
namespace {

using evaluate::PointDistances;
using evaluate::RoofBuilding;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;
using V = Eigen::Vector3d;

constexpr double kExact_m = 1e-12;

evaluate::RoofFace level_square(double from, double to, double z) {
  return evaluate::make_roof_face(
      "", {{V(from, from, z), V(to, from, z), V(to, to, z), V(from, to, z)}});
}

/// A flat roof of 10 m x 10 m at z = 5 that overhangs its wall at x = 1 and its ground at z = 0.
RoofBuilding shed() {
  RoofBuilding building{"shed", {level_square(0.0, 10.0, 5.0)}, {level_square(1.0, 9.0, 0.0)}};
  building.others.push_back(
      evaluate::make_roof_face("", {{V(1, 1, 0), V(1, 9, 0), V(1, 9, 5), V(1, 1, 5)}}));
  return building;
}

PointDistances distances_of(const std::vector<V>& points,
                            const std::vector<std::uint8_t>& classes = {}) {
  const RoofBuilding building = shed();
  return point_distances(grid_of(points), std::span(&building, 1), classes)[0];
}

TEST(PointDistances, AreZeroOnEverySurface) {
  const PointDistances found =
      distances_of({V(5, 5, 5), V(1, 4, 2), V(3, 3, 0), V(0.2, 9.8, 5)}, {6, 6, 6, 6});
  EXPECT_EQ(found.to_surface_m.size(), 4U);
  EXPECT_THAT(found.to_surface_m, Each(testing::Lt(kExact_m)));
}

TEST(PointDistances, AreThoseOfTheNearestSurface) {
  const PointDistances found = distances_of({V(0.7, 4, 2), V(10.3, 5, 5.4)}, {6, 6});
  EXPECT_THAT(found.to_surface_m, UnorderedElementsAre(testing::DoubleNear(0.3, kExact_m),
                                                       testing::DoubleNear(0.5, kExact_m)));
}

TEST(PointDistances, LeaveOutPointsFarBesideAndPlantsWaterAndNoise) {
  EXPECT_THAT(distances_of({V(10.6, 5, 5)}, {6}).to_surface_m, IsEmpty());
  for (const int of_class : {3, 4, 5, 7, 9, 18})
    EXPECT_THAT(distances_of({V(5, 5, 7)}, {static_cast<std::uint8_t>(of_class)}).to_surface_m,
                IsEmpty());
}

TEST(PointDistances, LeaveOutTheGround) {
  EXPECT_EQ(distances_of({V(10.3, 5, 0.4), V(10.3, 5, 0.6)}).to_surface_m.size(), 1U);
  EXPECT_EQ(distances_of({V(10.3, 5, 0.4), V(10.3, 5, 0.6)}, {6, 2}).to_surface_m.size(), 1U);
}

TEST(PointDistances, ToTheRoofAreVertical) {
  const PointDistances found = distances_of({V(5, 5, 5.25), V(5, 6, 4.9)}, {6, 6});
  EXPECT_THAT(found.to_roof_m, UnorderedElementsAre(testing::DoubleNear(0.25, kExact_m),
                                                    testing::DoubleNear(0.1, kExact_m)));
}

TEST(PointDistances, ToTheRoofLeaveOutWhatRaysPastItMeet) {
  // 2 m below the roof, within reach of a ray past its edge and not
  EXPECT_THAT(distances_of({V(1, 5, 3)}, {6}).to_roof_m, IsEmpty());
  EXPECT_THAT(distances_of({V(5, 5, 3)}, {6}).to_roof_m,
              ElementsAre(testing::DoubleNear(2.0, kExact_m)));
}

TEST(PointDistances, CountWhatLiesFarBelowTheRoof) {
  const PointDistances found = distances_of({V(5, 5, 5), V(5, 6, 3.4), V(5, 7, 3.6)}, {6, 6, 6});
  EXPECT_EQ(found.n_over, 3);
  EXPECT_EQ(found.n_far_below, 1);
}

TEST(PointDistances, TellPointsOfTheRoofsShapeBelowIt) {
  const PointDistances found =
      distances_of({V(2, 2, 3.0), V(4, 6, 3.1), V(8, 3, 2.9), V(-0.3, 5, 0.0), V(-0.3, 6, 2.0)},
                   {6, 6, 6, 2, 6});
  ASSERT_TRUE(found.parallel_below_m);
  EXPECT_NEAR(*found.parallel_below_m, 2.0, kExact_m);
  ASSERT_TRUE(found.above_ground_m);
  EXPECT_NEAR(*found.above_ground_m, 2.4, kExact_m);  // the lower third of 0 and 2 m is at 0.6 m
  EXPECT_FALSE(distances_of({V(2, 2, 3.0), V(4, 6, 1.0), V(8, 3, 2.0)}).parallel_below_m);
  EXPECT_FALSE(distances_of({V(2, 2, 3.0)}).above_ground_m);
}

TEST(PointDistances, DoNotDependOnTheOrderOfPoints) {
  const std::vector<V> points{V(5, 5, 5.1), V(2, 3, 4.9), V(7, 7, 5.3), V(2, 3, 4.9)};
  const std::vector<V> reversed(points.rbegin(), points.rend());
  EXPECT_EQ(distances_of(points).to_surface_m, distances_of(reversed).to_surface_m);
  EXPECT_EQ(distances_of(points).to_surface_m.size(), 3U);
}

TEST(PointDistances, OfABuildingWithoutARoofAreNone) {
  const RoofBuilding building{"b", {}};
  const auto found = point_distances(grid_of({V(0, 0, 0)}), std::span(&building, 1), {});
  EXPECT_THAT(found[0].to_surface_m, IsEmpty());
}

}  // namespace
}  // namespace ridgeline::test
