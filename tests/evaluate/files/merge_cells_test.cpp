// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/merge_cells.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ridgeline::results {
namespace {

using evaluate::ScanEdge;
using evaluate::ScanEdges;
using evaluate::ScanPlane;

constexpr double kRounding_m = 1e-9;

ScanEdge edge(const Eigen::Vector3d& start, const Eigen::Vector3d& end, double sigma_m = 0.02) {
  ScanEdge made{.segment = {start, end}, .kind = "ridge", .planes = {}};
  made.covariance_m2 = sigma_m * sigma_m * Eigen::Matrix<double, 6, 6>::Identity();
  made.support = 1.0;
  return made;
}

/// A level plane over a rectangle.
ScanPlane level_plane(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double z) {
  ScanPlane made;
  made.rings = {{{low.x(), low.y(), z},
                 {high.x(), low.y(), z},
                 {high.x(), high.y(), z},
                 {low.x(), high.y(), z}}};
  const Eigen::Vector2d middle = 0.5 * (low + high);
  made.fit.centroid = {middle.x(), middle.y(), z};
  made.fit.plane = Plane3(Eigen::Vector3d::UnitZ(), made.fit.centroid);
  made.area_m2 = (high - low).prod();
  made.is_roof = true;
  return made;
}

FoundInCell in_cell(std::int64_t column, std::vector<ScanEdge> edges) {
  return {{0, column}, {.planes = {}, .edges = std::move(edges)}};
}

TEST(MergeCells, EdgeThatTwoCellsSeeIsKeptOnceAsTheCellOfItsMiddleSeesIt) {
  const ScanEdge in_first = edge({90.0, 50.0, 8.0}, {109.0, 50.0, 8.0});
  const ScanEdge in_second = edge({90.1, 50.1, 8.0}, {108.8, 50.0, 8.0});
  const ScanEdges merged = merge_cells({in_cell(1, {in_second}), in_cell(0, {in_first})}, {});
  ASSERT_EQ(merged.edges.size(), 1U);
  EXPECT_EQ(merged.edges[0].segment.start, in_first.segment.start);
}

TEST(MergeCells, EdgeWhoseMiddleIsSeenOnEitherSideOfABorderIsNotLost) {
  const ScanEdge seen_too_far_right = edge({91.0, 50.0, 8.0}, {110.0, 50.0, 8.0});
  const ScanEdge seen_too_far_left = edge({90.0, 50.0, 8.0}, {109.0, 50.0, 8.0});
  const ScanEdges merged =
      merge_cells({in_cell(0, {seen_too_far_right}), in_cell(1, {seen_too_far_left})}, {});
  ASSERT_EQ(merged.edges.size(), 1U);
  EXPECT_EQ(merged.edges[0].segment.start, seen_too_far_right.segment.start);
}

TEST(MergeCells, EdgeOfThreeCellsIsJoinedFromItsPieces) {
  // from 20 to 280, as the boxes of the cells cut it
  ScanEdge left = edge({20.0, 50.0, 8.0}, {130.0, 50.0, 8.0}, 0.01);
  const ScanEdge middle = edge({70.0, 50.1, 8.0}, {230.0, 50.1, 8.0}, 0.02);
  ScanEdge right = edge({280.0, 50.0, 8.0}, {170.0, 50.0, 8.0}, 0.03);
  left.support = 0.5;
  right.moved_out_m = 0.2;
  const ScanEdges merged =
      merge_cells({in_cell(0, {left}), in_cell(1, {middle}), in_cell(2, {right})}, {});
  ASSERT_EQ(merged.edges.size(), 1U);
  const ScanEdge& joined = merged.edges[0];
  EXPECT_EQ(joined.segment.start, left.segment.start);
  EXPECT_EQ(joined.segment.end, right.segment.start);
  EXPECT_NEAR(joined.covariance_m2(0, 0), 0.01 * 0.01, kRounding_m);
  EXPECT_NEAR(joined.covariance_m2(3, 3), 0.03 * 0.03, kRounding_m);
  EXPECT_NEAR(joined.covariance_m2(0, 3), 0.0, kRounding_m);
  // pieces reach 1 m over the border: 81, 102 and 81 m
  EXPECT_NEAR(joined.support, (0.5 * 81.0 + 102.0 + 81.0) / 264.0, kRounding_m);
  EXPECT_NEAR(joined.moved_out_m, 0.2 * 81.0 / 264.0, kRounding_m);
}

TEST(MergeCells, WholeEdgeReplacesThePieceThatItsNeighbourSees) {
  const ScanEdge cut = edge({70.0, 50.0, 8.0}, {130.0, 50.0, 8.0});
  const ScanEdge whole = edge({75.0, 50.0, 8.0}, {140.0, 50.0, 8.0});
  const ScanEdges merged = merge_cells({in_cell(0, {cut}), in_cell(1, {whole})}, {});
  ASSERT_EQ(merged.edges.size(), 1U);
  EXPECT_EQ(merged.edges[0].segment.end, whole.segment.end);
}

TEST(MergeCells, EdgesInALineStayTwo) {
  const ScanEdge one = edge({80.0, 50.0, 8.0}, {99.8, 50.0, 8.0});
  const ScanEdge next = edge({100.0, 50.0, 8.0}, {118.0, 50.0, 8.0});
  EXPECT_EQ(merge_cells({in_cell(0, {one}), in_cell(1, {next})}, {}).edges.size(), 2U);
}

TEST(MergeCells, EdgesOfDifferentHeightStayTwo) {
  const ScanEdge one = edge({92.0, 50.0, 8.0}, {109.0, 50.0, 8.0});
  const ScanEdge above = edge({92.0, 50.0, 9.0}, {109.0, 50.0, 9.0});
  const ScanEdges merged = merge_cells({in_cell(0, {one, above}), in_cell(1, {one, above})}, {});
  EXPECT_EQ(merged.edges.size(), 2U);
}

TEST(MergeCells, PlaneThatTwoCellsSeeIsOneForTheEdgesOfBoth) {
  // A house on the border: its eave belongs to the left cell, its ridge to the right one.
  const ScanPlane in_first = level_plane({95.0, 40.0}, {109.0, 60.0}, 8.0);
  const ScanPlane in_second = level_plane({95.2, 40.1}, {109.0, 60.0}, 8.02);
  ScanEdge eave = edge({95.0, 40.0, 8.0}, {95.0, 60.0, 8.0});
  ScanEdge ridge = edge({109.0, 40.0, 8.0}, {109.0, 60.0, 8.0});
  eave.planes = {0};
  ridge.planes = {0};
  const FoundInCell first{{0, 0}, {.planes = {in_first}, .edges = {eave}}};
  const FoundInCell second{{0, 1}, {.planes = {in_second}, .edges = {ridge}}};
  const ScanEdges merged = merge_cells({first, second}, {});
  ASSERT_EQ(merged.planes.size(), 1U);
  EXPECT_EQ(merged.planes[0].fit.centroid, in_second.fit.centroid);
  ASSERT_EQ(merged.edges.size(), 2U);
  EXPECT_EQ(merged.edges[0].planes, std::vector<std::size_t>{0});
  EXPECT_EQ(merged.edges[1].planes, std::vector<std::size_t>{0});
}

TEST(MergeCells, PlanesOneAboveTheOtherStayTwo) {
  const ScanPlane lower = level_plane({95.0, 40.0}, {104.0, 60.0}, 8.0);
  const ScanPlane upper = level_plane({96.0, 40.0}, {106.0, 60.0}, 9.0);
  const FoundInCell first{{0, 0}, {.planes = {lower, upper}, .edges = {}}};
  const FoundInCell second{{0, 1}, {.planes = {lower, upper}, .edges = {}}};
  EXPECT_EQ(merge_cells({first, second}, {}).planes.size(), 2U);
}

TEST(MergeCells, PlaneOfThreeCellsHasTheAreaOfAllItsParts) {
  const FoundInCell left{{0, 0}, {.planes = {level_plane({20, 40}, {130, 60}, 8.0)}, .edges = {}}};
  const FoundInCell mid{{0, 1}, {.planes = {level_plane({70, 40}, {230, 60}, 8.0)}, .edges = {}}};
  const FoundInCell right{{0, 2},
                          {.planes = {level_plane({170, 40}, {280, 60}, 8.0)}, .edges = {}}};
  const ScanEdges merged = merge_cells({left, mid, right}, {});
  ASSERT_EQ(merged.planes.size(), 1U);
  EXPECT_NEAR(merged.planes[0].area_m2, 260.0 * 20.0, kRounding_m);
  EXPECT_EQ(merged.planes[0].rings.size(), 3U);
}

TEST(MergeCells, EdgeKeepsAPlaneThatBelongsToNoCell) {
  const ScanPlane behind = level_plane({101.0, 40.0}, {120.0, 60.0}, 8.0);
  ScanEdge eave = edge({101.0, 40.0, 8.0}, {101.0, 60.0, 8.0});
  eave.planes = {0};
  const ScanEdges merged =
      merge_cells({{{0, 0}, {.planes = {behind}, .edges = {eave}}}, in_cell(1, {})}, {});
  ASSERT_EQ(merged.edges.size(), 1U);
  EXPECT_EQ(merged.planes.size(), 1U);
}

}  // namespace
}  // namespace ridgeline::results
