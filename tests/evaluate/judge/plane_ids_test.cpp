// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plane_ids.h"

#include <gmock/gmock.h>

#include <vector>

namespace ridgeline::evaluate {
namespace {

using ::testing::ElementsAre;

/// A line at `x_m` judged by a plane that was fitted to the points first, ..., last - 1.
JudgedResult line_on(std::uint64_t first, std::uint64_t last, double x_m) {
  JudgedResult result;
  result.evaluation.segment = Segment3{{x_m, 0.0, 0.0}, {x_m, 1.0, 0.0}};
  result.evaluation.planes.emplace_back();
  for (std::uint64_t point = first; point < last; ++point) {
    result.inlier_keys.resize(1);
    result.inlier_keys[0].push_back((point + 1) * 0x9e3779b97f4a7c15ULL);
  }
  return result;
}

std::vector<LineEvaluation*> lines_of(std::vector<JudgedResult>& results) {
  std::vector<LineEvaluation*> lines;
  for (JudgedResult& result : results) lines.push_back(&result.evaluation);
  return lines;
}

std::vector<std::uint64_t> ids_of(std::vector<JudgedResult> results) {
  find_shared_points(results);
  identify_planes(lines_of(results));
  std::vector<std::uint64_t> ids;
  for (const JudgedResult& result : results) ids.push_back(result.evaluation.planes[0].id);
  return ids;
}

TEST(PlaneIds, AreOneWhereThreeTenthsOfThePointsAreShared) {
  EXPECT_THAT(ids_of({line_on(0, 100, 0.0), line_on(70, 170, 1.0)}), ElementsAre(1, 1));
  EXPECT_THAT(ids_of({line_on(0, 100, 0.0), line_on(71, 171, 1.0)}), ElementsAre(1, 2));
}

TEST(PlaneIds, FollowTheMostPointsAndTheirFirstPlane) {
  // The third plane has 40 points of the first and 60 of the second, which were not the first's.
  EXPECT_THAT(ids_of({line_on(0, 100, 0.0), line_on(100, 200, 1.0), line_on(60, 160, 2.0)}),
              ElementsAre(1, 2, 2));
  // Points that both have count for the first.
  EXPECT_THAT(ids_of({line_on(0, 100, 0.0), line_on(80, 280, 1.0), line_on(40, 130, 2.0)}),
              ElementsAre(1, 2, 1));
}

TEST(PlaneIds, GoByThePlacesOfTheLinesAndNotByTheirOrder) {
  EXPECT_THAT(ids_of({line_on(71, 171, 1.0), line_on(0, 100, 0.0)}), ElementsAre(2, 1));
}

TEST(PlaneIds, RestOnCountsAloneAndRefuseThoseOfNoEarlierPlane) {
  std::vector<JudgedResult> results{line_on(0, 100, 0.0), line_on(50, 150, 1.0)};
  find_shared_points(results);
  const PlanePoints& points = results[1].evaluation.planes[0].points;
  EXPECT_EQ(points.n, 100U);
  ASSERT_EQ(points.shared.size(), 1U);
  EXPECT_EQ(points.shared[0].n, 50U);
  std::vector<LineEvaluation*> lines = lines_of(results);
  lines[0] = nullptr;  // a line in none of the areas
  identify_planes(lines);
  EXPECT_EQ(lines[1]->planes[0].id, 1U);
  lines.resize(1);
  results[0].evaluation.planes[0].points.shared = {{7, 0, 50}};
  lines[0] = &results[0].evaluation;
  EXPECT_THROW(identify_planes(lines), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::evaluate
