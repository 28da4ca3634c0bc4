// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/faces/face_seams.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

namespace ridgeline {
namespace {

using testing::ElementsAre;

Face face_of(const Ring& ring) { return {{ring}, FaceKind::kUnknown, 0, ""}; }

/// Two squares of 10 m beside each other; the second one may have its edge in pieces.
std::vector<Face> squares(const std::vector<double>& divided_at) {
  Ring second{{10, 0, 0}, {20, 0, 0}, {20, 10, 0}, {10, 10, 0}};
  for (auto y = divided_at.rbegin(); y != divided_at.rend(); ++y) second.push_back({10, *y, 0});
  return {face_of({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}), face_of(second)};
}

std::size_t n_common(const std::vector<FaceSeam>& seams) {
  return static_cast<std::size_t>(
      std::ranges::count_if(seams, [](const FaceSeam& seam) { return seam.faces.size() == 2; }));
}

TEST(FaceSeams, FacesMeetAlongACommonEdge) {
  const auto seams = seams_of(squares({}));
  EXPECT_EQ(seams.size(), 7U);
  ASSERT_EQ(n_common(seams), 1U);
  const auto common = std::ranges::find(seams, 2U, [](const auto& s) { return s.faces.size(); });
  EXPECT_THAT(common->faces, ElementsAre(0U, 1U));
  EXPECT_DOUBLE_EQ(length(common->segment), 10.0);
}

TEST(FaceSeams, VerticesWithinAnEdgeOfTheNeighbourDoNotDivideIt) {
  const auto seams = seams_of(squares({3.0, 7.5}));
  EXPECT_EQ(seams.size(), 7U);
  EXPECT_EQ(n_common(seams), 1U);
}

TEST(FaceSeams, EndWhereTheNeighbourEnds) {
  std::vector<Face> faces = squares({});
  for (Eigen::Vector3d& x : faces[1].rings[0]) x.y() += 4.0;
  const auto seams = seams_of(faces);
  ASSERT_EQ(n_common(seams), 1U);
  const auto common = std::ranges::find(seams, 2U, [](const auto& s) { return s.faces.size(); });
  EXPECT_DOUBLE_EQ(length(common->segment), 6.0);
}

TEST(FaceSeams, VerticesWithinACentimetreAreOne) {
  std::vector<Face> faces = squares({});
  for (Eigen::Vector3d& x : faces[1].rings[0]) x += Eigen::Vector3d(0.004, -0.003, 0.002);
  EXPECT_EQ(n_common(seams_of(faces)), 1U);
  for (Eigen::Vector3d& x : faces[1].rings[0]) x.z() += 0.02;
  EXPECT_EQ(n_common(seams_of(faces)), 0U);
}

TEST(FaceSeams, BridgeToAHoleIsNone) {
  // The ring runs to the hole and back along the diagonal.
  const auto seams = seams_of(std::vector{face_of({{0, 0, 0},
                                                   {10, 0, 0},
                                                   {10, 10, 0},
                                                   {0, 10, 0},
                                                   {0, 0, 0},
                                                   {4, 4, 0},
                                                   {4, 6, 0},
                                                   {6, 6, 0},
                                                   {6, 4, 0},
                                                   {4, 4, 0}})});
  EXPECT_EQ(seams.size(), 8U);
}

TEST(FaceSeams, CoordinatesFarOffOrNotFiniteAreNoTrouble) {
  std::vector<Face> faces = squares({});
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  faces.push_back(face_of({{0, 0, 0}, {1e300, 0, 0}, {0, kInfinity, 0}}));
  faces.push_back(face_of({{1e9, 1e9, 0}, {1e9 + 1, 1e9, 0}, {1e9, 1e9 + 1, 0}}));
  EXPECT_EQ(seams_of(faces).size(), 10U);
  EXPECT_TRUE(seams_of({}).empty());
}

}  // namespace
}  // namespace ridgeline
