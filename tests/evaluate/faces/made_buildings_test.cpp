// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/made_buildings.h"

#include "tests/support/made_points.h"

#include <Eigen/Dense>
#include <gmock/gmock.h>

#include <map>
#include <set>
#include <tuple>

namespace ridgeline::test {
namespace {

constexpr double kRounding_m = 1e-9;  // rounding at coordinates of 1000 m

using Place = std::tuple<double, double, double>;
Place place_of(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

std::vector<BuildingSpec> all_shapes() {
  std::vector<BuildingSpec> specs;
  for (int i = 0; i < kNumRoofShapes; ++i) {
    specs.push_back({.shape = static_cast<RoofShape>(i),
                     .azimuth_deg = 17.0 * i,
                     .position = {100.0 * i, 1000.0, 30.0}});
  }
  return specs;
}

/// Twice the area vector of a face, outwards: holes run the other way round.
Eigen::Vector3d twice_area(const MadeFace& face) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& ring : face.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Eigen::Vector3d from = ring[i] - face.rings[0][0];
      sum += from.cross(ring[(i + 1) % ring.size()] - face.rings[0][0]);
    }
  }
  return sum;
}

double roof_area_in_plan(const MadeBuilding& building) {
  double area = 0.0;
  for (const MadeFace& face : building.faces) {
    if (face.kind == MadeSurface::kRoof) area += 0.5 * twice_area(face).z();
  }
  return area;
}

std::map<MadeEdgeKind, int> edge_counts(RoofShape shape) {
  std::map<MadeEdgeKind, int> counts;
  for (const MadeEdge& edge : make_building({.shape = shape}).edges) ++counts[edge.kind];
  return counts;
}

TEST(MakeBuilding, GivesClosedShellsOfFlatFaces) {
  for (const BuildingSpec& spec : all_shapes()) {
    SCOPED_TRACE(static_cast<int>(spec.shape));
    const MadeBuilding building = make_building(spec);
    std::multiset<std::pair<Place, Place>> open;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const MadeFace& face : building.faces) {
      sum += twice_area(face);
      const Eigen::Vector3d normal = twice_area(face).normalized();
      for (const auto& ring : face.rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          EXPECT_NEAR(normal.dot(ring[i] - ring[0]), 0.0, kRounding_m);
          const std::pair edge(place_of(ring[i]), place_of(ring[(i + 1) % ring.size()]));
          const auto duplicate = open.find({edge.second, edge.first});
          duplicate == open.end() ? void(open.insert(edge)) : void(open.erase(duplicate));
        }
      }
    }
    EXPECT_TRUE(open.empty());
    EXPECT_LT(sum.norm(), 1e-9 * 1000.0);
  }
}

TEST(MakeBuilding, TurnsFacesOutwards) {
  for (const BuildingSpec& spec : all_shapes()) {
    const MadeBuilding building = make_building(spec);
    double six_volumes = 0.0;
    for (const MadeFace& face : building.faces) {
      const Eigen::Vector3d out = twice_area(face);
      six_volumes += out.dot(face.rings[0][0] - spec.position);
      if (face.kind == MadeSurface::kRoof) {
        EXPECT_GT(out.z(), 0.0);
      }
      if (face.kind == MadeSurface::kGround) {
        EXPECT_LT(out.z(), 0.0);
      }
      if (face.kind == MadeSurface::kWall) {
        EXPECT_NEAR(out.z(), 0.0, 1e-7);
      }
    }
    EXPECT_GT(six_volumes / 6.0, 0.9 * roof_area_in_plan(building) * 4.5);
  }
}

TEST(MakeBuilding, CoversItsFootprintOnce) {
  const auto area = [](RoofShape shape) {
    return roof_area_in_plan(make_building({.shape = shape}));
  };
  for (const RoofShape shape :
       {RoofShape::kGable, RoofShape::kHip, RoofShape::kPyramid, RoofShape::kHalfHip,
        RoofShape::kMansard, RoofShape::kShed, RoofShape::kFlat, RoofShape::kDormer}) {
    EXPECT_NEAR(area(shape), 12.0 * 8.0, kRounding_m) << static_cast<int>(shape);
  }
  EXPECT_NEAR(area(RoofShape::kLShape), 12.0 * 8.0 + 4.0 * 8.0, kRounding_m);
  EXPECT_NEAR(area(RoofShape::kTShape), 12.0 * 8.0 + 5.6 * 4.8, kRounding_m);
  EXPECT_NEAR(area(RoofShape::kAnnex), 12.0 * 8.0 + 7.2 * 3.0, kRounding_m);
}

TEST(RoofEdges, AreThoseOfTheShape) {
  using enum MadeEdgeKind;
  using Counts = std::map<MadeEdgeKind, int>;
  EXPECT_EQ(edge_counts(RoofShape::kGable), (Counts{{kRidge, 1}, {kEave, 2}, {kVerge, 4}}));
  EXPECT_EQ(edge_counts(RoofShape::kHip), (Counts{{kRidge, 1}, {kHip, 4}, {kEave, 4}}));
  EXPECT_EQ(edge_counts(RoofShape::kPyramid), (Counts{{kHip, 4}, {kEave, 4}}));
  EXPECT_EQ(edge_counts(RoofShape::kHalfHip),
            (Counts{{kRidge, 1}, {kHip, 4}, {kEave, 4}, {kVerge, 4}}));
  EXPECT_EQ(edge_counts(RoofShape::kMansard), (Counts{{kRidge, 5}, {kHip, 8}, {kEave, 4}}));
  EXPECT_EQ(edge_counts(RoofShape::kShed), (Counts{{kEave, 2}, {kVerge, 2}}));
  EXPECT_EQ(edge_counts(RoofShape::kFlat), (Counts{{kStep, 12}}));
  EXPECT_EQ(edge_counts(RoofShape::kLShape),
            (Counts{{kRidge, 2}, {kHip, 1}, {kValley, 1}, {kEave, 4}, {kVerge, 4}}));
  EXPECT_EQ(edge_counts(RoofShape::kTShape),
            (Counts{{kRidge, 2}, {kValley, 2}, {kEave, 5}, {kVerge, 6}}));
  EXPECT_EQ(edge_counts(RoofShape::kDormer),
            (Counts{{kRidge, 2}, {kValley, 2}, {kEave, 4}, {kVerge, 6}, {kStep, 3}}));
  EXPECT_EQ(edge_counts(RoofShape::kAnnex),
            (Counts{{kRidge, 1}, {kEave, 3}, {kVerge, 6}, {kStep, 1}}));
}

TEST(RoofEdges, StayWholeAtTJunctions) {
  const BuildingSpec whole{.shape = RoofShape::kHip};
  BuildingSpec split = whole;
  split.t_junctions = true;
  EXPECT_EQ(make_building(split).faces.size(), make_building(whole).faces.size() + 1);
  EXPECT_EQ(make_building(split).edges.size(), make_building(whole).edges.size());
  EXPECT_NEAR(roof_area_in_plan(make_building(split)), 12.0 * 8.0, kRounding_m);
  EXPECT_EQ(make_building(split).faces[4].kind, MadeSurface::kRoof);
}

TEST(MakeBuilding, RefusesASizeThatDoesNotGiveTheShape) {
  EXPECT_THROW(make_building({.shape = RoofShape::kHip, .length_m = 8.0}), std::invalid_argument);
  EXPECT_THROW(make_building({.shape = RoofShape::kPyramid, .t_junctions = true}),
               std::invalid_argument);
}

TEST(Scan, LiesOnTheRoofOrTheGround) {
  const MadeBuilding building =
      make_building({.azimuth_deg = 30.0, .position = {50.0, 20.0, 10.0}});
  const double slope = std::tan(35.0 * std::numbers::pi / 180.0);
  int n_roof = 0;
  const std::vector<Eigen::Vector3d> points = scan(std::span(&building, 1), {.sigma_m = 0.0});
  for (const Eigen::Vector3d& x : points) {
    const Eigen::Vector2d own =
        Eigen::Rotation2Dd(-std::numbers::pi / 6.0) * Eigen::Vector2d(x.x() - 50.0, x.y() - 20.0);
    const bool on_roof = std::abs(own.x()) < 6.0 && std::abs(own.y()) < 4.0;
    n_roof += on_roof ? 1 : 0;
    EXPECT_NEAR(x.z(), on_roof ? 15.0 + slope * (4.0 - std::abs(own.y())) : 10.0, kRounding_m);
  }
  EXPECT_NEAR(n_roof, 5.0 * 96.0, 3.0 * std::sqrt(480.0));
}

TEST(Scan, SeesTheUppermostOfSeveralRoofs) {
  std::vector<MadeBuilding> buildings;
  for (const double height_m : {6.0, 9.0, 3.0}) {
    buildings.push_back(
        make_building({.shape = RoofShape::kShed, .eave_height_m = height_m, .pitch_deg = 0.0}));
  }
  for (const Eigen::Vector3d& x : scan(buildings, {.sigma_m = 0.0, .margin_m = 0.0})) {
    EXPECT_NEAR(x.z(), 9.0, kRounding_m);
  }
}

TEST(Scan, HasItsNoiseAlongTheNormal) {
  const MadeBuilding building =
      make_building({.shape = RoofShape::kShed, .length_m = 100.0, .width_m = 100.0});
  const double slope = std::tan(35.0 * std::numbers::pi / 180.0);
  const auto rms = [&](NoiseDirection noise) {
    const ScanSpec spec{.sigma_m = 0.1, .noise = noise, .margin_m = 0.0};
    double squares = 0.0;
    const std::vector<Eigen::Vector3d> points = scan(std::span(&building, 1), spec);
    for (const Eigen::Vector3d& x : points) {
      squares += std::pow(x.z() - 5.0 - slope * (x.y() + 50.0), 2.0) / (1.0 + slope * slope);
    }
    return std::sqrt(squares / static_cast<double>(points.size()));
  };
  EXPECT_NEAR(rms(NoiseDirection::kNormal), 0.1, 0.002);  // 4 sigma of 50000 points
  EXPECT_NEAR(rms(NoiseDirection::kVertical), 0.1 / std::hypot(1.0, slope), 0.002);
}

}  // namespace
}  // namespace ridgeline::test
