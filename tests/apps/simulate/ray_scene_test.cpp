// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/ray_scene.h"

#include "apps/simulate/mesh_builder.h"
#include "apps/simulate/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ridgeline::simulate {
namespace {

/// A bumpy ground of n x n cells of 1 m, two triangles each.
Mesh bumpy_ground(int n) {
  const auto height = [](int i, int k) { return std::sin(0.9 * i) + std::cos(1.3 * k + 0.4 * i); };
  Mesh mesh;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const auto corner = [&](int a, int b) {
        return Eigen::Vector3d(i + a, k + b, height(i + a, k + b));
      };
      add_polygon({corner(0, 0), corner(1, 0), corner(1, 1)}, {}, mesh);
      add_polygon({corner(0, 0), corner(1, 1), corner(0, 1)}, {}, mesh);
    }
  }
  return mesh;
}

TEST(RayScene, HitsTheNearestTriangleAtItsExactDistance) {
  Mesh mesh;
  add_polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, mesh);
  add_polygon({{0, 0, 1.0 / 3.0}, {1, 0, 1.0 / 3.0}, {0, 1, 1.0 / 3.0}}, {}, mesh);
  const RayScene rays(mesh);
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
  const auto hit = rays.first_hit({0.2, 0.3, 2.0}, down);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->triangle, 1);
  EXPECT_NEAR(hit->distance_m, 2.0 - 1.0 / 3.0, 1e-15);  // float alone would give 1e-7
  const auto next = rays.first_hit({0.2, 0.3, 2.0}, down, hit->distance_m + 0.01);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->triangle, 0);
}

TEST(RayScene, GivesNothingBesideOrBeyondTheMesh) {
  Mesh mesh;
  add_polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, mesh);
  const RayScene rays(mesh);
  EXPECT_FALSE(rays.first_hit({0.8, 0.8, 2.0}, -Eigen::Vector3d::UnitZ()));
  EXPECT_FALSE(rays.first_hit({0.2, 0.2, 2.0}, Eigen::Vector3d::UnitZ()));
  EXPECT_FALSE(RayScene(Mesh{}).first_hit({0.0, 0.0, 1.0}, -Eigen::Vector3d::UnitZ()));
}

TEST(RayScene, FindsWhatLiesBetweenTwoDistances) {
  Mesh mesh;
  add_polygon({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {}, mesh);
  const RayScene rays(mesh);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  EXPECT_TRUE(rays.occluded({0.2, 0.3, 0.0}, up));
  EXPECT_FALSE(rays.occluded({0.2, 0.3, 0.0}, up, 1.1));
  EXPECT_FALSE(rays.occluded({0.2, 0.3, 0.0}, up, 0.0, 0.9));
  EXPECT_FALSE(rays.occluded({0.8, 0.8, 0.0}, up));
}

TEST(RayScene, AnswersManyRaysAsOneByOne) {
  const Mesh mesh = bumpy_ground(20);
  const RayScene rays(mesh);
  Random random({9});
  std::vector<RayScene::Ray> many;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d origin{random.uniform(-2.0, 22.0), random.uniform(-2.0, 22.0), 9.0};
    many.push_back({origin, Eigen::Vector3d(0.1, random.uniform(), -1.0).normalized()});
  }
  const auto hits = rays.first_hits(many);
  const std::vector<char> occluded = rays.occluded(many);
  ASSERT_EQ(hits.size(), many.size());
  ASSERT_EQ(occluded.size(), many.size());
  for (std::size_t i = 0; i < many.size(); ++i) {
    const auto alone = rays.first_hit(many[i].origin, many[i].direction);
    ASSERT_EQ(hits[i].has_value(), alone.has_value()) << i;
    EXPECT_EQ(occluded[i] != 0, alone.has_value()) << i;
    if (!alone) continue;
    EXPECT_EQ(hits[i]->triangle, alone->triangle) << i;
  }
}

TEST(RayScene, LosesNoRayBetweenTwoTriangles) {
  constexpr int kCells = 30;
  const Mesh mesh = bumpy_ground(kCells);
  const RayScene rays(mesh);
  Random random({8});
  int lost = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    // aimed at the edge from the first to the second corner of an inner cell, shared with the next
    const int column = random.integer(2, kCells - 3);
    const int triangle = 2 * (kCells * column + random.integer(2, kCells - 3));
    const auto& v = mesh.triangles[static_cast<std::size_t>(triangle)].vertices;
    const double t = random.uniform();
    const Eigen::Vector3d target = (1.0 - t) * mesh.vertices[static_cast<std::size_t>(v[0])] +
                                   t * mesh.vertices[static_cast<std::size_t>(v[1])];
    const Eigen::Vector3d origin(random.uniform(5.0, 25.0), random.uniform(5.0, 25.0), 40.0);
    lost += rays.first_hit(origin, (target - origin).normalized()) ? 0 : 1;
  }
  EXPECT_EQ(lost, 0);  // without Embree's robust mode about 8500 are
}

}  // namespace
}  // namespace ridgeline::simulate
