// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/shared_planes.h"

#include "evaluate/tables/area_json.h"

#include <gmock/gmock.h>

#include <vector>

namespace ridgeline::evaluate {
namespace {

/// A line judged by a plane that was fitted to the points first, ..., last - 1.
LineEvaluation line_on(std::uint64_t first, std::uint64_t last, std::uint64_t id, double x_m) {
  constexpr std::uint64_t kMultiplier = 0x9e3779b97f4a7c15ULL;
  std::vector<std::uint64_t> keys;
  for (std::uint64_t point = first; point < last; ++point) keys.push_back(point * kMultiplier);
  LineEvaluation line;
  line.segment = Segment3{{x_m, 0.0, 0.0}, {x_m, 1.0, 0.0}};
  line.planes.emplace_back().id = id;
  line.planes.back().sample = point_sample(keys);
  return line;
}

/// The ids of the planes of two runs of two lines each, once they are joined.
std::vector<std::uint64_t> joined(std::vector<LineEvaluation> lines) {
  std::vector<LineEvaluation*> a{&lines[0], &lines[1]}, b{&lines[2], &lines[3]};
  const std::vector<JudgedRun> runs{a, b};
  join_planes(runs);
  std::vector<std::uint64_t> ids;
  for (const LineEvaluation& line : lines) ids.push_back(line.planes.front().id);
  return ids;
}

TEST(JoinedPlanes, OfTwoRunsAreOneIfTheyShareTheirPoints) {
  const auto ids = joined({line_on(0, 1000, 1, 0.0), line_on(5000, 6000, 2, 1.0),
                           line_on(400, 1400, 1, 2.0), line_on(9000, 9900, 2, 3.0)});
  EXPECT_EQ(ids[0], ids[2]);
  EXPECT_NE(ids[0], ids[1]);
  EXPECT_NE(ids[1], ids[3]);
  EXPECT_NE(ids[2], ids[3]);
}

TEST(JoinedPlanes, ThatShareOnlyTheirEdgeStayApart) {
  const auto ids = joined({line_on(0, 1000, 1, 0.0), line_on(0, 1000, 1, 1.0),
                           line_on(950, 1950, 1, 2.0), line_on(950, 1950, 1, 3.0)});
  EXPECT_EQ(ids[0], ids[1]);
  EXPECT_EQ(ids[2], ids[3]);
  EXPECT_NE(ids[0], ids[2]);
}

TEST(JoinedPlanes, TakeTheLinesThatShareTheirPointsAndNoOthersOfTheirRun) {
  const auto ids = joined({line_on(0, 1000, 7, 0.0), line_on(900, 1900, 7, 1.0),
                           line_on(3000, 4000, 4, 2.0), line_on(1000, 2000, 4, 3.0)});
  EXPECT_THAT(ids, testing::ElementsAre(1, 1, 2, 1));
}

TEST(JoinedPlanes, KeepTheirSamplesInText) {
  const std::vector<std::uint32_t> sample = line_on(3, 500, 1, 0.0).planes.front().sample;
  EXPECT_EQ(parse_sample(sample_text(sample)), sample);
  EXPECT_THROW(parse_sample("AB C."), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::evaluate
