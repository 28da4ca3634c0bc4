// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/find_edges.h"

#include "reconstruct/geometry/degrees.h"
#include "tests/support/made_buildings.h"
#include "tests/support/made_points.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace ridgeline::evaluate {
namespace {

using test::BuildingSpec;
using test::MadeBuilding;
using test::MadeEdge;
using test::MadeEdgeKind;
using test::RoofShape;
using test::scan;

constexpr test::ScanSpec kExactScan{.points_per_m2 = 20.0, .sigma_m = 0.0};

MadeBuilding building_of(RoofShape shape) {
  BuildingSpec spec;
  spec.shape = shape;
  spec.azimuth_deg = 25.0;
  return make_building(spec);
}

bool is_seam(const MadeEdge& edge) {
  return edge.kind == MadeEdgeKind::kRidge || edge.kind == MadeEdgeKind::kHip ||
         edge.kind == MadeEdgeKind::kValley;
}

/// Distance of the middle of `a` from the infinite line of `b`, HUGE_VAL if they are not parallel.
double distance_m(const Segment3& a, const Segment3& b) {
  constexpr double kMaxAngle_deg = 5.0;
  const Eigen::Vector3d d = (b.end - b.start).normalized();
  if (acute_angle_rad(Eigen::Vector3d(a.end - a.start), d) > kMaxAngle_deg * kRadPerDeg)
    return HUGE_VAL;
  const Eigen::Vector3d x = midpoint(a) - b.start;
  const double s = d.dot(x);
  return s < 0.0 || s > length(b) ? HUGE_VAL : (x - s * d).norm();
}

const ScanEdge* nearest(const ScanEdges& found, const Segment3& edge) {
  const auto best = std::ranges::min_element(
      found.edges, {}, [&](const ScanEdge& e) { return distance_m(e.segment, edge); });
  return best == found.edges.end() || distance_m(best->segment, edge) == HUGE_VAL ? nullptr
                                                                                  : &*best;
}

class ExactRoof : public ::testing::TestWithParam<RoofShape> {};

TEST_P(ExactRoof, HasExactSeams) {
  constexpr double kMinLength_m = 2.0, kTolerance_m = 1e-6;
  const MadeBuilding building = building_of(GetParam());
  const ScanEdges found = find_edges(scan({&building, 1}, kExactScan));
  for (const MadeEdge& edge : building.edges) {
    if (!is_seam(edge) || length(edge.segment) < kMinLength_m) continue;
    const ScanEdge* const best = nearest(found, edge.segment);
    ASSERT_NE(best, nullptr);
    EXPECT_LE(distance_m(best->segment, edge.segment), kTolerance_m);
    EXPECT_EQ(best->planes.size(), 2U);
  }
}

TEST_P(ExactRoof, HasItsBordersWithinTheGapOfThePoints) {
  constexpr double kMinLength_m = 3.0, kTolerance_m = 0.15;
  const MadeBuilding building = building_of(GetParam());
  const ScanEdges found = find_edges(scan({&building, 1}, kExactScan));
  int n = 0, n_found = 0;
  for (const MadeEdge& edge : building.edges) {
    if (is_seam(edge) || length(edge.segment) < kMinLength_m) continue;
    ++n;
    const ScanEdge* const best = nearest(found, edge.segment);
    n_found += best != nullptr && distance_m(best->segment, edge.segment) <= kTolerance_m ? 1 : 0;
  }
  // some lie in a gap of the random points
  EXPECT_GE(5 * n_found, 4 * n) << n_found << " of " << n;
}

TEST_P(ExactRoof, HasNoOtherEdges) {
  constexpr double kMinLength_m = 2.0, kTolerance_m = 0.3;
  const MadeBuilding building = building_of(GetParam());
  const ScanEdges found = find_edges(scan({&building, 1}, kExactScan));
  for (const ScanEdge& edge : found.edges) {
    if (length(edge.segment) < kMinLength_m) continue;
    const bool is_right = std::ranges::any_of(building.edges, [&](const MadeEdge& made) {
      return distance_m(edge.segment, made.segment) <= kTolerance_m;
    });
    EXPECT_TRUE(is_right) << edge.kind << " of " << length(edge.segment) << " m at "
                          << midpoint(edge.segment).transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes,
                         ExactRoof,
                         ::testing::Values(RoofShape::kGable,
                                           RoofShape::kHip,
                                           RoofShape::kPyramid,
                                           RoofShape::kHalfHip,
                                           RoofShape::kMansard,
                                           RoofShape::kShed,
                                           RoofShape::kFlat,
                                           RoofShape::kLShape,
                                           RoofShape::kTShape,
                                           RoofShape::kDormer,
                                           RoofShape::kAnnex));

std::vector<std::string> described(const ScanEdges& found) {
  std::vector<std::string> lines;
  for (const ScanEdge& e : found.edges) {
    std::ostringstream text;
    text.precision(17);
    text << e.kind << ' ' << e.segment.start.transpose() << ' ' << e.segment.end.transpose() << ' '
         << e.covariance_m2.diagonal().transpose() << ' ' << e.support << ' ' << e.moved_out_m;
    lines.push_back(text.str());
  }
  return lines;
}

TEST(FindEdges, DoesNotDependOnTheOrderOfThePoints) {
  const MadeBuilding building = building_of(RoofShape::kTShape);
  std::vector<Eigen::Vector3d> points = scan({&building, 1}, {});
  const std::vector<std::string> first = described(find_edges(points));
  ASSERT_GT(first.size(), 8U);
  std::ranges::reverse(points);
  std::rotate(points.begin(), points.begin() + 137, points.end());
  points.push_back(points.front());  // repeated
  points.emplace_back(0.0, std::nan(""), 0.0);
  EXPECT_EQ(described(find_edges(points)), first);
}

TEST(FindEdges, OfAGableMeetAtItsCorners) {
  const MadeBuilding building = building_of(RoofShape::kGable);
  const ScanEdges found = find_edges(scan({&building, 1}, {}));
  std::map<std::string, int> n_of_kind;
  for (const ScanEdge& e : found.edges) ++n_of_kind[e.kind];
  EXPECT_EQ(n_of_kind["ridge"], 1);
  EXPECT_EQ(n_of_kind["eave"], 2);
  EXPECT_EQ(n_of_kind["verge"], 4);
  const auto ridge = std::ranges::find(found.edges, "ridge", &ScanEdge::kind);
  int n_at_ends = 0;
  for (const ScanEdge& e : found.edges) {
    if (e.kind != "verge") continue;
    for (const Eigen::Vector3d& end : {ridge->segment.start, ridge->segment.end})
      n_at_ends += e.segment.start == end || e.segment.end == end ? 1 : 0;
  }
  EXPECT_EQ(n_at_ends, 4);
}

TEST(FindEdges, StateTheCovarianceOfARidge) {
  // normalised squared errors across the ridge, at its middle: chi-square with 2 degrees of freedom
  constexpr int kTrials = 150;
  double sum = 0.0;
  int n = 0;
  const MadeBuilding building = building_of(RoofShape::kGable);
  const auto made = std::ranges::find(building.edges, MadeEdgeKind::kRidge, &MadeEdge::kind);
  for (int trial = 0; trial < kTrials; ++trial) {
    test::ScanSpec spec;
    spec.seed = 500 + static_cast<std::uint64_t>(trial);
    const ScanEdges found = find_edges(scan({&building, 1}, spec));
    const ScanEdge* const edge = nearest(found, made->segment);
    ASSERT_NE(edge, nullptr);
    const Eigen::Vector3d d = (made->segment.end - made->segment.start).normalized();
    Eigen::Matrix<double, 3, 2> across;
    across << d.unitOrthogonal(), d.cross(d.unitOrthogonal());
    Eigen::Matrix<double, 3, 6> to_middle;
    to_middle << 0.5 * Eigen::Matrix3d::Identity(), 0.5 * Eigen::Matrix3d::Identity();
    const Eigen::Matrix2d c =
        across.transpose() * to_middle * edge->covariance_m2 * to_middle.transpose() * across;
    const Eigen::Vector2d e = across.transpose() * (midpoint(edge->segment) - made->segment.start);
    sum += e.dot(c.inverse() * e);
    ++n;
  }
  const double mean = sum / (2.0 * n);
  EXPECT_GE(mean, 0.75);  // 1 but for the scatter of 150 trials, 0.08, three times
  EXPECT_LE(mean, 1.25);
}

TEST(FindEdges, FindsNoneInTrees) {
  // crowns of random points above level ground
  test::Random random(7);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 18000; ++i)
    points.emplace_back(random.uniform(-30.0, 30.0), random.uniform(-30.0, 30.0),
                        random.normal(0.034));
  for (int tree = 0; tree < 20; ++tree) {
    const Eigen::Vector3d top(random.uniform(-25.0, 25.0), random.uniform(-25.0, 25.0), 7.0);
    for (int i = 0; i < 300; ++i) {
      const Eigen::Vector3d d(random.normal(1.0), random.normal(1.0), random.normal(1.0));
      points.push_back(top + 3.0 * random.uniform(0.6, 1.0) * d.normalized());
    }
  }
  EXPECT_TRUE(find_edges(points).edges.empty());
}

TEST(FindEdges, EndsOfTheScanAreNoEdges) {
  // half of a house: the scan ends across its roof
  const MadeBuilding building = building_of(RoofShape::kGable);
  std::vector<Eigen::Vector3d> points = scan({&building, 1}, {});
  std::erase_if(points, [](const Eigen::Vector3d& x) { return x.x() > 0.0; });
  for (const ScanEdge& e : find_edges(points).edges)
    EXPECT_FALSE(e.segment.start.x() > -0.5 && e.segment.end.x() > -0.5) << e.kind;
}

TEST(FindEdges, OfRoofsAloneAreWhereThePointsEnd) {
  const MadeBuilding building = building_of(RoofShape::kHip);
  std::vector<Eigen::Vector3d> points = scan({&building, 1}, {});
  std::erase_if(points, [](const Eigen::Vector3d& x) { return x.z() < 2.0; });
  EXPECT_TRUE(find_edges(points).edges.empty());
  const ScanEdges found = find_edges(points, {.only_roofs = true});
  EXPECT_EQ(std::ranges::count(found.edges, "eave", &ScanEdge::kind), 4);
  EXPECT_GE(std::ranges::count(found.edges, "hip", &ScanEdge::kind), 4);
}

TEST(FindEdges, OfTooFewPointsAreNone) {
  EXPECT_TRUE(find_edges({}).edges.empty());
  const std::vector<Eigen::Vector3d> few(10, Eigen::Vector3d::Zero());
  EXPECT_TRUE(find_edges(few).planes.empty());
}

}  // namespace
}  // namespace ridgeline::evaluate
