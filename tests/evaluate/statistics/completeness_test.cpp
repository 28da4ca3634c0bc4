// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/completeness.h"

#include "evaluate/statistics/compare_with_scan.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace ridgeline::evaluate {
namespace {

constexpr double kRoundingError = 1e-12;

/// An edge along x from `from_m` to `to_m` at the height of a roof.
Segment3 along_x(double from_m, double to_m, double y_m = 0.0, double z_m = 8.0) {
  return {{from_m, y_m, z_m}, {to_m, y_m, z_m}};
}

Segment3 turned(const Segment3& segment, double angle_deg) {
  const double angle_rad = angle_deg * std::numbers::pi / 180.0;
  const double run_m = length(segment);
  return {segment.start,
          segment.start + run_m * Eigen::Vector3d(std::cos(angle_rad), std::sin(angle_rad), 0.0)};
}

/// A scan whose edges have a plane each.
class MadeScan {
 public:
  ScanEdge& add(const Segment3& segment, const std::string& kind = "ridge") {
    ScanPlane& plane = scan.planes.emplace_back();
    plane.fit.centroid = midpoint(segment);
    scan.edges.push_back(
        {.segment = segment, .kind = kind, .planes = {scan.planes.size() - 1}, .support = 1.0});
    return scan.edges.back();
  }

  [[nodiscard]] Completeness found_by(const std::vector<Segment3>& lines) const {
    return compare_with_scan(lines, lines, scan, scope, {});
  }

  ScanEdges scan;
  ScanScope scope{.area_from = "lines", .area_m2 = 100.0, .contains = [](const Eigen::Vector2d&) {
                    return true;
                  }};
};

MadeScan one_edge(double length_m = 10.0) {
  MadeScan made;
  made.add(along_x(0.0, length_m));
  return made;
}

double covered(const Completeness& completeness) { return completeness.edges.at(0).covered; }

TEST(CompareWithScan, FindsAnEdgeOfWhichTwoLinesCoverHalfTogether) {
  const MadeScan made = one_edge();
  // A line within the tolerance also covers what lies within 0.3 m of its ends.
  const Segment3 left = along_x(0.0, 2.2);
  const Segment3 right = along_x(7.8, 10.0);
  EXPECT_NEAR(covered(made.found_by({left, right})), 0.5, kRoundingError);
  EXPECT_TRUE(made.found_by({left, along_x(7.79, 10.0)}).edges[0].is_found());
  EXPECT_FALSE(made.found_by({left}).edges[0].is_found());
  EXPECT_FALSE(made.found_by({left, left}).edges[0].is_found());
}

TEST(CompareWithScan, NeedsADistanceOf30CentimetresAtMost) {
  const MadeScan made = one_edge();
  EXPECT_GT(covered(made.found_by({along_x(0.0, 10.0, 0.29)})), 0.99);
  EXPECT_EQ(covered(made.found_by({along_x(0.0, 10.0, 0.31)})), 0.0);
  EXPECT_EQ(covered(made.found_by({along_x(0.0, 10.0, 0.0, 8.31)})), 0.0);
}

TEST(CompareWithScan, NeedsAnAngleOf5DegreesAtMost) {
  const MadeScan made = one_edge(2.5);
  EXPECT_TRUE(made.found_by({turned(along_x(0.0, 2.5), 4.9)}).edges[0].is_found());
  EXPECT_EQ(covered(made.found_by({turned(along_x(0.0, 2.5), 6.0)})), 0.0);
}

TEST(CompareWithScan, CountsEdgesOf2MetresWithSupportInTheArea) {
  MadeScan made;
  made.add(along_x(0.0, 1.9));
  made.add(along_x(10.0, 15.0)).support = 0.79;
  made.add(along_x(20.0, 29.0));
  made.add(along_x(26.0, 40.0));
  made.scope.contains = [](const Eigen::Vector2d& x) { return x.x() < 30.0; };
  const Completeness found = made.found_by({});
  ASSERT_EQ(found.edges.size(), 1U);
  EXPECT_EQ(found.edges[0].length_m, 9.0);
}

TEST(CompareWithScan, CountsLinesThatFollowNoEdgeOfAnyLength) {
  MadeScan made;
  made.add(along_x(0.0, 1.5)).support = 0.1;
  const Completeness found =
      made.found_by({along_x(0.0, 2.0), along_x(0.0, 4.0), along_x(0.0, 2.0, 5.0)});
  EXPECT_EQ(found.n_lines, 3U);
  EXPECT_EQ(found.n_without_edge, 2U);
}

TEST(CompareWithScan, LinesThatAreNotCountedFindEdges) {
  const MadeScan made = one_edge();
  const std::vector<Segment3> lines{along_x(0.0, 10.0)};
  const Completeness found = compare_with_scan(lines, {}, made.scan, made.scope, {});
  EXPECT_TRUE(found.edges[0].is_found());
  EXPECT_EQ(found.n_lines, 0U);
}

TEST(CompareWithScan, IgnoresLinesWithoutLengthAndRefusesInfiniteOnes) {
  const MadeScan made = one_edge(0.5);
  EXPECT_EQ(made.found_by({along_x(0.2, 0.2)}).n_lines, 0U);
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)made.found_by({along_x(0.0, infinite)}), std::invalid_argument);
}

TEST(CompareWithScan, CountsEdgesApartThatNoTwoImagesShow) {
  MadeScan made;
  made.add(along_x(0.0, 5.0), "eave");
  made.add(along_x(10.0, 15.0), "eave");
  made.scope.is_shown = [](const Segment3& s) { return s.start.x() > 5.0; };
  const Completeness found = made.found_by({along_x(0.0, 5.0)});
  const CompletenessRow* row = find_row(found, "eave");
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->n, 1U);
  EXPECT_EQ(row->n_found, 0U);
  EXPECT_EQ(row->n_not_shown, 1U);
}

TEST(CompletenessRows, GroupByKindAndLength) {
  MadeScan made;
  made.add(along_x(0.0, 3.0), "ridge");
  made.add(along_x(10.0, 14.0), "ridge");
  made.add(along_x(20.0, 28.0), "eave");
  const Completeness found = made.found_by({along_x(0.0, 3.0), along_x(20.0, 25.7)});
  std::vector<std::string> names;
  for (const CompletenessRow& row : found.rows) names.push_back(row.kind + " " + row.length);
  EXPECT_THAT(names, testing::ElementsAre("ridge all", "ridge 2-4", "ridge 4-8", "eave all",
                                          "eave 8+", "all all", "all 2-4", "all 4-8", "all 8+"));
  const CompletenessRow& all = *find_row(found, "all");
  EXPECT_NEAR(*all.recall(), 2.0 / 3.0, kRoundingError);
  EXPECT_NEAR(*all.recall_by_length(), 9.0 / 15.0, kRoundingError);
  EXPECT_EQ(find_row(found, "valley"), nullptr);
}

/// Houses of four edges on one plane each; every `every`-th house is found.
MadeScan village(std::size_t n_houses) {
  MadeScan made;
  for (std::size_t house = 0; house < n_houses; ++house) {
    const double x_m = 20.0 * static_cast<double>(house);
    for (int k = 0; k < 4; ++k) {
      ScanEdge& edge = made.add(along_x(x_m, x_m + 5.0, 3.0 * k), "eave");
      edge.planes = {made.scan.planes.size() - 1 - static_cast<std::size_t>(k)};
    }
  }
  return made;
}

std::vector<Segment3> lines_of_every_third(const MadeScan& made) {
  std::vector<Segment3> lines;
  for (std::size_t i = 0; i < made.scan.edges.size(); ++i) {
    if ((i / 4) % 3 == 0) lines.push_back(made.scan.edges[i].segment);
  }
  return lines;
}

TEST(CompletenessRows, DrawConnectedPlanesForTheInterval) {
  const MadeScan made = village(30);
  const Completeness found = made.found_by(lines_of_every_third(made));
  const CompletenessRow& row = *find_row(found, "all");
  EXPECT_EQ(row.n, 120U);
  EXPECT_EQ(row.n_clusters, 30U);
  ASSERT_TRUE(row.ci95);
  // 30 houses of which all or none of the edges are found: sigma = sqrt(1/3 2/3 / 30) = 0.086
  EXPECT_NEAR(row.ci95->low, 1.0 / 3.0 - 1.96 * 0.086, 0.04);
  EXPECT_NEAR(row.ci95->high, 1.0 / 3.0 + 1.96 * 0.086, 0.04);
}

TEST(CompletenessRows, EdgesConnectedByPlanesAreOneCluster) {
  MadeScan made;
  made.add(along_x(0.0, 5.0));
  made.add(along_x(10.0, 15.0)).planes = {0, 1};
  made.add(along_x(20.0, 25.0)).planes = {1, 2};
  const CompletenessRow row = *find_row(made.found_by({}), "all");
  EXPECT_EQ(row.n_clusters, 1U);
  EXPECT_FALSE(row.ci95);
}

TEST(CompletenessRows, NoneFoundStillHasAnInterval) {
  const CompletenessRow row = *find_row(village(30).found_by({}), "all");
  EXPECT_EQ(row.recall(), 0.0);
  EXPECT_GT(row.ci95->high, 0.01);
}

TEST(PooledCompleteness, EqualsThatOfAllAreasAtOnce) {
  MadeScan made = village(40);
  made.scan.edges[79].planes.push_back(made.scan.edges[80].planes[0]);  // across the border
  const std::vector<Segment3> lines = lines_of_every_third(made);
  const Completeness whole = made.found_by(lines);
  constexpr double kBorder_m = 400.0;
  made.scope.contains = [](const Eigen::Vector2d& x) { return x.x() < kBorder_m; };
  const Completeness west = made.found_by(lines);
  made.scope.contains = [](const Eigen::Vector2d& x) { return x.x() >= kBorder_m; };
  const Completeness east = compare_with_scan(lines, {}, made.scan, made.scope, {});
  const Completeness both = pooled({&west, &east}, {});
  EXPECT_EQ(both.n_lines, whole.n_lines);
  EXPECT_EQ(both.area_m2, 200.0);
  ASSERT_EQ(both.rows.size(), whole.rows.size());
  for (std::size_t i = 0; i < both.rows.size(); ++i) {
    EXPECT_EQ(both.rows[i].n, whole.rows[i].n);
    EXPECT_EQ(both.rows[i].n_found, whole.rows[i].n_found);
    EXPECT_EQ(both.rows[i].n_clusters, whole.rows[i].n_clusters);
    EXPECT_EQ(both.rows[i].ci95->low, whole.rows[i].ci95->low);
    EXPECT_EQ(both.rows[i].ci95->high, whole.rows[i].ci95->high);
  }
  EXPECT_EQ(both.rows.back().n_clusters, 39U);
  EXPECT_THROW((void)pooled({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::evaluate
