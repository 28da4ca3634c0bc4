// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/settle_model.h"

#include "reconstruct/geometry/degrees.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Face bare_face(const Ring& ring, FaceKind kind = FaceKind::kUnknown) {
  return {{ring}, kind, 0, ""};
}

Face level(double x0, double x1, double y0, double y1, double z = 3.0) {
  return bare_face({{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}});
}

BuildingModel settled(std::vector<Face> faces) {
  BuildingModel model;
  model.buildings = {{"1", ""}};
  model.faces = std::move(faces);
  settle(model);
  return model;
}

std::vector<FaceKind> settled_kinds(const BuildingModel& model) {
  std::vector<FaceKind> kinds;
  for (const Face& face : model.faces) kinds.push_back(face.kind);
  return kinds;
}

double area_of(const Ring& ring) { return area_vector(ring).norm(); }

TEST(SettleModel, AFaceBelowAnotherIsTheGround) {
  std::vector<Face> faces{bare_face({{0, 0, 0}, {0, 9, 0}, {9, 9, 0}, {9, 0, 0}}),
                          bare_face({{0, 0, 3}, {9, 0, 3}, {9, 9, 5}, {0, 9, 5}}),
                          bare_face({{0, 0, 0}, {9, 0, 0}, {9, 0, 3}, {0, 0, 3}})};
  using enum FaceKind;
  EXPECT_THAT(settled_kinds(settled(faces)), ElementsAre(kGround, kRoof, kWall));
  faces[0].kind = kOther;
  EXPECT_THAT(settled_kinds(settled(faces)), ElementsAre(kOther, kRoof, kWall));
}

TEST(SettleModel, TrianglesOfAPlaneAreOneFaceThatTurnsAsTheyDo) {
  // A fan about a corner of a square of 6 m.
  const Ring corners{{0, 0, 3}, {6, 0, 3}, {6, 3, 3}, {6, 6, 3}, {3, 6, 3}, {0, 6, 3}};
  std::vector<Face> fan;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    fan.push_back(bare_face({corners[0], corners[i], corners[i + 1]}));
  const BuildingModel model = settled(fan);
  ASSERT_EQ(model.faces.size(), 1U);
  ASSERT_EQ(model.faces[0].rings.size(), 1U);
  EXPECT_DOUBLE_EQ(area_vector(model.faces[0].rings[0]).z(), 36.0);
  for (Face& face : fan) std::ranges::reverse(face.rings[0]);
  EXPECT_DOUBLE_EQ(area_vector(settled(fan).faces[0].rings[0]).z(), -36.0);
}

TEST(SettleModel, PiecesAroundAHoleKeepIt) {
  const BuildingModel model =
      settled({level(0, 9, 0, 3), level(0, 9, 6, 9), level(0, 3, 3, 6), level(6, 9, 3, 6)});
  ASSERT_EQ(model.faces.size(), 1U);
  ASSERT_EQ(model.faces[0].rings.size(), 2U);
  EXPECT_DOUBLE_EQ(area_of(model.faces[0].rings[0]), 81.0);
  EXPECT_DOUBLE_EQ(area_of(model.faces[0].rings[1]), 9.0);
  EXPECT_LT(area_vector(model.faces[0].rings[1]).z(), 0.0);
}

TEST(SettleModel, FacesOfOtherKindsPlanesOrPlacesStayApart) {
  std::vector<Face> faces{level(0, 3, 0, 3), level(3, 6, 0, 3), level(0, 3, 3, 6, 3.1),
                          level(20, 23, 0, 3)};
  faces[1].kind = FaceKind::kOther;
  EXPECT_EQ(settled(faces).faces.size(), 4U);
}

TEST(SettleModel, AVaultIsNoSingleFaceHoweverFineItsStrips) {
  constexpr int kStrips = 60;
  constexpr double kTurn_rad =
      0.4 * kRadPerDeg;  // from strip to strip; up to 0.5 degrees are one plane
  const auto corner = [](int i, double y) {
    const double angle_rad = (i - 0.5 * kStrips) * kTurn_rad;
    return Eigen::Vector3d(40.0 * std::sin(angle_rad), y, 40.0 * std::cos(angle_rad));
  };
  std::vector<Face> strips;
  for (int i = 0; i < kStrips; ++i)
    strips.push_back(
        bare_face({corner(i, 0.0), corner(i + 1, 0.0), corner(i + 1, 9.0), corner(i, 9.0)}));
  EXPECT_EQ(settled(strips).faces.size(), kStrips / 2U);  // two strips each
}

TEST(SettleModel, AnOutlineThatTouchesItselfLeavesThePieces) {
  // Squares about a hole that touches the outside at a corner.
  const auto model =
      settled({level(0, 3, 0, 3), level(3, 6, 0, 3), level(6, 9, 0, 3), level(6, 9, 3, 6),
               level(3, 6, 6, 9), level(6, 9, 6, 9), level(0, 3, 3, 6)});
  double area = 0.0;
  for (const Face& face : model.faces) area += area_of(face.rings[0]);
  EXPECT_DOUBLE_EQ(area, 63.0);
}

TEST(SettleModel, WhatIsNoFaceIsLeftOutAndCounted) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  Face holed = level(0, 9, 0, 9);
  holed.rings.push_back({{1, 1, 3}, {2, 2, 3}, {1, 1, 3}});
  const BuildingModel model = settled({holed, bare_face({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}),
                                       bare_face({{0, 0, 0}, {1, 0, kNaN}, {2, 2, 2}}),
                                       bare_face({{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}}),
                                       bare_face({{0, 0, 0}}), bare_face({})});
  ASSERT_EQ(model.faces.size(), 1U);
  EXPECT_EQ(model.faces[0].rings.size(), 1U);
  EXPECT_EQ(model.left_out.text(), "5 faces without an area");
}

TEST(SettleModel, IdsThatRepeatAreNumberedWithAWarning) {
  BuildingModel model;
  model.buildings = {{"a", ""}, {"a_1", ""}, {"a", ""}, {"a", ""}};
  settle(model);
  std::vector<std::string> ids;
  for (const Building& building : model.buildings) ids.push_back(building.id);
  EXPECT_THAT(ids, ElementsAre("a", "a_1", "a_2", "a_3"));
  EXPECT_THAT(model.warnings, ElementsAre(HasSubstr("2 buildings have the id of an earlier one")));
}

TEST(SettleModel, FacesOfABuildingStandTogether) {
  BuildingModel model;
  model.buildings = {{"1", ""}, {"2", ""}};
  for (const std::size_t building : {1U, 0U, 1U}) {
    model.faces.push_back(level(20.0 * static_cast<double>(model.faces.size()),
                                9.0 + 20.0 * static_cast<double>(model.faces.size()), 0, 9));
    model.faces.back().building = building;
  }
  settle(model);
  std::vector<std::pair<std::size_t, std::size_t>> groups;
  for_each_building(model, [&](std::size_t building, std::span<const Face> faces) {
    groups.emplace_back(building, faces.size());
  });
  EXPECT_THAT(groups, ElementsAre(std::pair(0U, 1U), std::pair(1U, 2U)));
}

}  // namespace
}  // namespace ridgeline::io
