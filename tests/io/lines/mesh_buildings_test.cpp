// SPDX-License-Identifier: BSD-3-Clause
// Which faces of an OBJ are a building, by their names and by how they are connected.
#include "io/lines/read_lines.h"
#include "tests/support/temp_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <functional>

namespace ridgeline::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

enum class Side { kRoof, kWall, kGround };

/// The records that name a face, from its house and its side.
using Naming = std::function<std::string(int house, Side side)>;

constexpr double kSize = 8.0, kEaves = 6.0;

/// A closed box with its lower corner at (x, y, z) as records of an OBJ with vertices of its own.
std::string box(
    const Eigen::Vector3d& corner, double size, double height, int house, const Naming& names) {
  std::string obj;
  const auto face = [&](Side side, const std::vector<Eigen::Vector3d>& ring) {
    obj += names(house, side);
    for (const Eigen::Vector3d& x : ring) {
      const Eigen::Vector3d at = corner + Eigen::Vector3d(size, size, height).cwiseProduct(x);
      obj += fmt::format("v {} {} {}\n", at.x(), at.y(), at.z());
    }
    obj += "f -4 -3 -2 -1\n";
  };
  face(Side::kRoof, {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}});
  face(Side::kGround, {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}});
  face(Side::kWall, {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}});
  face(Side::kWall, {{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}});
  face(Side::kWall, {{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {1, 1, 1}});
  face(Side::kWall, {{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {0, 1, 1}});
  return obj;
}

/// Two houses, 1 and 2, the second `gap` beside the first.
std::string houses(double gap, const Naming& names) {
  return box({500000, 5400000, 250}, kSize, kEaves, 1, names) +
         box({500000 + kSize + gap, 5400000, 250}, kSize, kEaves, 2, names);
}

const char* surface(Side side) {
  return side == Side::kRoof   ? "RoofSurface"
         : side == Side::kWall ? "WallSurface"
                               : "GroundSurface";
}

LineSet read_houses(const std::string& obj) {
  const TempFolder folder;
  return read_lines(folder.write("houses.obj", obj));
}

std::vector<std::string> building_ids(const LineSet& set) {
  std::vector<std::string> ids;
  for (const Building& building : set.model->buildings) ids.push_back(building.id);
  return ids;
}

/// Expects two closed boxes, each with one roof face of four edges.
void expect_two_houses(const LineSet& set) {
  ASSERT_TRUE(set.model);
  EXPECT_THAT(set.model->buildings, SizeIs(2));
  EXPECT_EQ(set.lines.size(), 8U);
  EXPECT_THAT(set.model->faces, SizeIs(12));
  for (const Line& line : set.lines)
    EXPECT_EQ(line.segment_in_world.start.z(), 250.0 + kEaves) << "the ground is no roof";
}

TEST(MeshBuildings, KindsOfSurfaceNameNoBuilding) {
  for (const Naming& names : std::vector<Naming>{
           [](int, Side side) { return fmt::format("g {}\n", surface(side)); },
           [](int, Side side) { return fmt::format("o {}.001\n", surface(side)); },
           [](int, Side side) { return fmt::format("g tile {}\n", surface(side)); },
           [](int, Side side) { return fmt::format("usemtl {}\n", surface(side)); }}) {
    const LineSet set = read_houses(houses(5.0, names));
    expect_two_houses(set);
  }
}

TEST(MeshBuildings, AWordOfAGroupBesideTheKindNamesTheBuilding) {
  for (const char* const form : {"g house_{} {}\n", "g house_{}_{}\n", "o house_{}\ng {}\n"}) {
    for (const double gap : {5.0, 0.0}) {  // also where houses have a wall in common
      const LineSet set = read_houses(houses(gap, [&](int house, Side side) {
        return fmt::format(fmt::runtime(form), house, surface(side));
      }));
      expect_two_houses(set);
      EXPECT_THAT(building_ids(set), ElementsAre("house_1", "house_2")) << form;
    }
  }
}

TEST(MeshBuildings, NamesOfFacesNameNoBuilding) {
  int number = 0;
  const LineSet set =
      read_houses(houses(5.0, [&](int, Side) { return fmt::format("g face_{}\n", ++number); }));
  expect_two_houses(set);
  EXPECT_THAT(building_ids(set), ElementsAre("1", "2"));
}

TEST(MeshBuildings, HousesApartOfOneNameAreTwo) {
  const LineSet set = read_houses(houses(5.0, [](int, Side) { return "o NL.IMBAG.1\n"; }));
  expect_two_houses(set);
  EXPECT_THAT(building_ids(set), ElementsAre("NL.IMBAG.1", "NL.IMBAG.1_1"));
  EXPECT_THAT(set.warnings, ElementsAre(HasSubstr("1 building has the id of an earlier one")));
}

TEST(MeshBuildings, PartsOfANameThatMeetOrCoverEachOtherAreOne) {
  const Naming name = [](int, Side) { return "o house\n"; };
  const Eigen::Vector3d corner(500000, 5400000, 250);
  const std::string house = box(corner, kSize, kEaves, 1, name);
  // A chimney that stands in the roof, and an annex on higher ground whose edges are not those of
  // the house.
  const std::string chimney = box(corner + Eigen::Vector3d(3, 3, 5), 1.0, 2.0, 1, name);
  const std::string annex = box(corner + Eigen::Vector3d(kSize, 1, 1), 4.0, 3.0, 1, name);
  for (const std::string& part : {chimney, annex}) {
    const LineSet set = read_houses(house + part);
    EXPECT_THAT(building_ids(set), ElementsAre("house"));
    EXPECT_THAT(set.warnings, IsEmpty());
  }
}

TEST(MeshBuildings, ARoofOfAnotherNameBelongsToItsWalls) {
  const LineSet set = read_houses(houses(5.0, [](int house, Side side) {
    return fmt::format("o {}_{}\n", side == Side::kRoof ? "hat" : "body", house);
  }));
  expect_two_houses(set);
  EXPECT_THAT(building_ids(set), ElementsAre("body_1", "body_2"));
}

TEST(MeshBuildings, KindsInNamesAreThoseOfTheFacesIfAllHaveOne) {
  // a wall that is called a roof
  const auto named = [](const char* of_first) {
    return houses(5.0, [=](int house, Side side) {
      return fmt::format("g {}\n", house == 1 && side == Side::kWall ? of_first : surface(side));
    });
  };
  const auto n_roofs = [](const LineSet& set) {
    return std::ranges::count(set.model->faces, FaceKind::kRoof, &Face::kind);
  };
  EXPECT_EQ(n_roofs(read_houses(named("RoofSurface"))), 6);
  EXPECT_EQ(n_roofs(read_houses(named("anything"))), 2);
}

}  // namespace
}  // namespace ridgeline::io
