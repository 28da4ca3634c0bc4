// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/model_edges.h"

#include "reconstruct/geometry/transformed.h"
#include "tests/io/models/made_model.h"
#include "tests/support/made_buildings.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <random>

namespace ridgeline::io {
namespace {

using test::BuildingSpec;
using test::MadeBuilding;
using test::MadeEdge;
using test::RoofShape;

constexpr double kExact_m = 1e-8;  // coordinates of millions of metres have 1e-9
constexpr std::array<const char*, 6> kKinds{"ridge", "hip", "valley", "eave", "verge", "step"};

bool is_same(const Segment3& a, const Segment3& b) {
  const auto near = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return (p - q).norm() < kExact_m;
  };
  return (near(a.start, b.start) && near(a.end, b.end)) ||
         (near(a.start, b.end) && near(a.end, b.start));
}

/// Buildings of all shapes, turned and of several sizes.
std::vector<MadeBuilding> buildings_of_all_shapes(bool t_junctions) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<MadeBuilding> buildings;
  for (int i = 0; i < 5 * test::kNumRoofShapes; ++i) {
    BuildingSpec spec;
    spec.shape = static_cast<RoofShape>(i % test::kNumRoofShapes);
    spec.width_m = 7.0 + 4.0 * share(random);
    spec.length_m = spec.width_m + 3.0 + 8.0 * share(random);
    spec.pitch_deg = 25.0 + 20.0 * share(random);
    spec.azimuth_deg = 360.0 * share(random);
    spec.position = {40.0 * i, 60.0 * share(random), share(random)};
    // These have no face of four corners that could be two.
    const bool is_whole = spec.shape == RoofShape::kPyramid || spec.shape == RoofShape::kHalfHip;
    spec.t_junctions = t_junctions && !is_whole;
    buildings.push_back(test::make_building(spec));
  }
  return buildings;
}

/// The lines of a building, each with its true edge; kinds and ends are to agree.
void expect_true_edges(const std::vector<MadeBuilding>& buildings, const LineSet& set) {
  std::size_t n_true = 0;
  for (std::size_t i = 0; i < buildings.size(); ++i) {
    for (const MadeEdge& edge : buildings[i].edges) {
      const Segment3 truth{edge.segment.start + kMadeOrigin, edge.segment.end + kMadeOrigin};
      const auto line = std::ranges::find_if(
          set.lines, [&](const Line& l) { return is_same(l.segment_in_world, truth); });
      ++n_true;
      ASSERT_NE(line, set.lines.end())
          << "shape " << static_cast<int>(buildings[i].spec.shape) << ": "
          << kKinds[static_cast<std::size_t>(edge.kind)] << " " << edge.segment.start.transpose()
          << " to " << edge.segment.end.transpose();
      EXPECT_EQ(line->kind, kKinds[static_cast<std::size_t>(edge.kind)])
          << "shape " << static_cast<int>(buildings[i].spec.shape);
      EXPECT_EQ(line->building, std::to_string(i + 1));
    }
  }
  EXPECT_EQ(set.lines.size(), n_true);
}

TEST(ModelEdges, AreTheTrueOnesOfAllRoofsWhoseFacesAreStated) {
  const auto buildings = buildings_of_all_shapes(false);
  expect_true_edges(buildings, lines_of_model(model_of(buildings, true)));
}

TEST(ModelEdges, AreTheTrueOnesWhereNoFaceSaysWhatItIs) {
  const auto buildings = buildings_of_all_shapes(false);
  expect_true_edges(buildings, lines_of_model(model_of(buildings, false)));
}

TEST(ModelEdges, AreWholeWhereAVertexLiesWithinAnEdgeOfTheNeighbour) {
  const auto buildings = buildings_of_all_shapes(true);
  expect_true_edges(buildings, lines_of_model(model_of(buildings, true)));
}

TEST(ModelEdges, DoNotDependOnTheWayThatRingsTurn) {
  const auto buildings = buildings_of_all_shapes(false);
  BuildingModel model = model_of(buildings, false);
  for (std::size_t i = 0; i < model.faces.size(); i += 2) {
    for (Ring& ring : model.faces[i].rings) std::ranges::reverse(ring);
  }
  expect_true_edges(buildings, lines_of_model(model));
}

TEST(ModelEdges, NameTheirFacesAndTheRowOfTheirBuilding) {
  const std::vector<MadeBuilding> buildings{test::make_building({}), test::make_building({})};
  const BuildingModel model = model_of(buildings, true);
  const LineSet set = lines_of_model(model);
  for (const Line& line : set.lines) {
    ASSERT_EQ(line.plane_ids.size(), line.kind == "ridge" ? 2U : 1U);
    for (const int face : line.plane_ids) {
      EXPECT_EQ(model.faces[static_cast<std::size_t>(face)].kind, FaceKind::kRoof);
      EXPECT_EQ(model.faces[static_cast<std::size_t>(face)].building, line.row);
    }
    EXPECT_EQ(line.building, std::to_string(line.row + 1));
    EXPECT_TRUE(line.id.starts_with(line.building + "."));
  }
  EXPECT_EQ(set.features.rows.size(), 2U);
  ASSERT_TRUE(set.model);
  EXPECT_EQ(set.model->faces.size(), model.faces.size());
}

/// A roof of two faces that differ by an angle, over a square of 10 m.
BuildingModel folded(double angle_deg) {
  const double h = 5.0 * std::tan(0.5 * angle_deg * M_PI / 180.0);
  BuildingModel model;
  model.buildings = {{"1", "2"}};
  const auto face = [&](double x, FaceKind kind) {
    model.faces.push_back({{{{0, 0, h}, {x, 0, 0}, {x, 10, 0}, {0, 10, h}}}, kind, 0, ""});
  };
  face(-5.0, FaceKind::kRoof);
  face(5.0, FaceKind::kRoof);
  return model;
}

TEST(ModelEdges, NearlyCoplanarNeighboursHaveNone) {
  const auto n_ridges = [](const BuildingModel& model) {
    const LineSet set = lines_of_model(model);
    return std::ranges::count(set.lines, "ridge", &Line::kind);
  };
  EXPECT_EQ(n_ridges(folded(4.9)), 0);
  EXPECT_EQ(n_ridges(folded(5.1)), 1);
}

TEST(ModelEdges, FacesThatAreNoneAreCounted) {
  BuildingModel model = folded(60.0);
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  model.faces.push_back({{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}, FaceKind::kRoof, 0, ""});
  model.faces.push_back({{{{0, 0, 0}, {1, 0, kNaN}, {2, 2, 2}}}, FaceKind::kRoof, 0, ""});
  const LineSet set = lines_of_model(model);
  EXPECT_THAT(set.left_out.text(), testing::HasSubstr("2 faces without an area"));
  EXPECT_EQ(std::ranges::count(set.lines, "ridge", &Line::kind), 1);
}

TEST(ModelEdges, DuplicateVerticesDoNotDivideOrLoseAnEdge) {
  BuildingModel model = folded(60.0);
  Ring& ring = model.faces[0].rings[0];
  ring.insert(ring.begin(), ring.front());
  ring.push_back(ring.front());
  ring[2] += Eigen::Vector3d(0.004, 0.0, 0.0);
  EXPECT_EQ(lines_of_model(model).lines.size(), lines_of_model(folded(60.0)).lines.size());
}

TEST(ModelEdges, FacesThatRepeatAreOne) {
  BuildingModel model = folded(60.0);
  const std::vector<Face> once = model.faces;
  for (Face face : once) {
    std::ranges::reverse(face.rings[0]);
    face.kind = FaceKind::kUnknown;
    model.faces.push_back(face);
  }
  const LineSet set = lines_of_model(model);
  EXPECT_EQ(set.lines.size(), lines_of_model(folded(60.0)).lines.size());
  EXPECT_EQ(set.model->faces.size(), once.size());
  EXPECT_EQ(set.left_out.text(), "2 repeated faces");
}

TEST(ModelEdges, ThreeRoofFacesAtOneEdgeGiveNoLine) {
  BuildingModel model = folded(60.0);
  Face third = model.faces[0];
  for (Eigen::Vector3d& x : third.rings[0])
    if (x.x() != 0.0) x.z() -= 2.0;
  model.faces.push_back(third);
  const LineSet set = lines_of_model(model);
  EXPECT_EQ(std::ranges::count(set.lines, "ridge", &Line::kind), 0);
  EXPECT_THAT(set.left_out.text(), testing::HasSubstr("1 edge of three roof faces or more"));
}

}  // namespace
}  // namespace ridgeline::io
