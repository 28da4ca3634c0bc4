// SPDX-License-Identifier: BSD-3-Clause
#include "tests/evaluate/faces/judged_building.h"

#include <gmock/gmock.h>

#include <limits>

namespace ridgeline::test {
namespace {

using evaluate::make_roof_face;
using evaluate::RoofFace;
using V = Eigen::Vector3d;

constexpr double kTolerance = 1e-9;
const std::vector<V> kSquare{V(0, 0, 1), V(4, 0, 1), V(4, 3, 4), V(0, 3, 4)};  // 45 degrees

TEST(MakeRoofFace, GivesPlaneAreaAndCentroid) {
  const RoofFace face = make_roof_face("a", {kSquare});
  ASSERT_FALSE(face.degenerate);
  EXPECT_TRUE(face.plane.normal().isApprox(V(0, -1, 1).normalized(), kTolerance));
  EXPECT_NEAR(face.area_m2, 12.0 * std::sqrt(2.0), kTolerance);
  EXPECT_NEAR(face.plan.area_m2(), 12.0, kTolerance);
  EXPECT_TRUE(face.centroid.isApprox(V(2.0, 1.5, 2.5), kTolerance));
  EXPECT_NEAR(face.flatness_m, 0.0, kTolerance);
}

TEST(MakeRoofFace, TakesRingsOfEitherDirection) {
  const std::vector<V> hole{V(0.5, 0.5, 1.5), V(1.5, 0.5, 1.5), V(1.5, 1.5, 2.5), V(0.5, 1.5, 2.5)};
  const RoofFace face = make_roof_face("a", {kSquare, hole});
  EXPECT_NEAR(face.area_m2, 11.0 * std::sqrt(2.0), kTolerance);
  EXPECT_NEAR(face.centroid.x(), (12.0 * 2.0 - 1.0) / 11.0, kTolerance);
  for (const bool turn_outer : {false, true}) {
    Rings rings{kSquare, hole};
    std::ranges::reverse(rings[turn_outer ? 0 : 1]);
    const RoofFace turned = make_roof_face("a", rings);
    EXPECT_NEAR(turned.area_m2, face.area_m2, kTolerance);
    EXPECT_TRUE(turned.plane.isApprox(face.plane, kTolerance));
    EXPECT_TRUE(turned.centroid.isApprox(face.centroid, kTolerance));
  }
}

TEST(MakeRoofFace, TellsHowFarVerticesAreFromTheirPlane) {
  // one corner raised by 4 d: the plane of a square passes all four at d
  Rings rings{{V(0, 0, 0), V(10, 0, 0), V(10, 10, 0.4), V(0, 10, 0)}};
  EXPECT_NEAR(make_roof_face("a", rings).flatness_m, 0.1, 1e-4);
}

TEST(MakeRoofFace, KeepsItsFiguresFarFromTheOrigin) {
  Rings far{kSquare};
  const V offset(500000.0, 5800000.0, 100.0);
  for (V& x : far[0]) x += offset;
  const RoofFace face = make_roof_face("a", far);
  EXPECT_NEAR(face.area_m2, 12.0 * std::sqrt(2.0), kTolerance);
  EXPECT_TRUE((face.centroid - offset).isApprox(V(2.0, 1.5, 2.5), 1e-8));  // rounding at 5,800 km
}

TEST(MakeRoofFace, TellsDegenerateFaces) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Rings> bad{
      {},
      {{}},
      {{V(0, 0, 0), V(1, 0, 0)}},
      {{V(0, 0, 0), V(1, 0, 0), V(2, 0, 0)}},
      {{V(0, 0, 0), V(1, nan, 0), V(0, 1, 0)}},
      {{V(0, 0, 0), V(1, 0, std::numeric_limits<double>::infinity()), V(0, 1, 0)}},
      {{V(0, 0, 0), V(1, 0, 0), V(0, 2e7, 0)}},
      {{V(0, 0, 0), V(2e4, 0, 0), V(0, 1, 0)}},
      {kSquare, kSquare},
      {kSquare, {V(1, 1, 1)}}};
  for (const Rings& rings : bad) EXPECT_TRUE(make_roof_face("a", rings).degenerate);
}

TEST(MakeRoofFace, TakesWalls) {
  const RoofFace wall = make_roof_face("a", {{V(0, 0, 0), V(4, 0, 0), V(4, 0, 3), V(0, 0, 3)}});
  EXPECT_FALSE(wall.degenerate);
  EXPECT_NEAR(wall.area_m2, 12.0, kTolerance);
  EXPECT_EQ(wall.plan.area_m2(), 0.0);
  EXPECT_TRUE(wall.centroid.isApprox(V(2, 0, 1.5), kTolerance));
}

}  // namespace
}  // namespace ridgeline::test
