// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/fittings.h"

#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace ridgeline::simulate {
namespace {

constexpr double kPitchDeg = 35.0;

TEST(AddFittings, LeavesAFaceThatOthersBuryBare) {
  SyntheticScene scene = test::gabled_house(kPitchDeg);
  SyntheticScene with_buried_face = scene;
  ScenePlane buried = scene.planes.back();
  ASSERT_EQ(buried.kind, PlaneKind::kRoof);
  buried.id = static_cast<int>(scene.planes.size());
  buried.outline.clear();
  // enough of them to draw solar panels and skylights
  constexpr int kFaces = 20;
  with_buried_face.planes.insert(with_buried_face.planes.end(), kFaces, buried);

  const std::size_t n_bare = scene.mesh.triangles.size();
  add_fittings(scene, 1);
  add_fittings(with_buried_face, 1);
  EXPECT_GT(scene.mesh.triangles.size(), n_bare);
  EXPECT_EQ(with_buried_face.mesh.vertices, scene.mesh.vertices);
}

}  // namespace
}  // namespace ridgeline::simulate
