// SPDX-License-Identifier: BSD-3-Clause
// The truth that the judge is measured by, on hard scenes of both renderers.
#include "tests/acceptance/hard_survey.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace ridgeline::test {
namespace {

constexpr std::uint64_t kTrainingSeed = 3;

class HardSurveyOf : public testing::TestWithParam<Renderer> {};

TEST_P(HardSurveyOf, LinesLieOnTheirSurfaces) {
  constexpr double kSurfaceTol_m = 1e-9;
  const HardSurvey survey = hard_survey(kTrainingSeed, 1.0, GetParam());
  ASSERT_GT(survey.lines.size(), 500U);
  for (const HardLine& line : survey.lines) {
    const auto distance_m = true_mean_distance_m(line, line.segment);
    EXPECT_EQ(distance_m.has_value(), line.kind != "object");
    if (distance_m) {
      EXPECT_LT(*distance_m, kSurfaceTol_m) << line.kind;
    }
  }
}

TEST_P(HardSurveyOf, HasLinesOfAllKindsWithAsManyPlanes) {
  std::map<std::string, std::set<std::size_t>> planes;
  for (const HardLine& line : hard_survey(kTrainingSeed, 1.0, GetParam()).lines) {
    planes[line.kind].insert(line.planes.size());
  }
  for (const char* kind : {"ridge", "valley"}) {
    EXPECT_EQ(planes[kind], (std::set<std::size_t>{2})) << kind;
  }
  for (const char* kind : {"eave", "verge", "ground", "foot", "wall_top"}) {
    EXPECT_EQ(planes[kind], (std::set<std::size_t>{1})) << kind;
  }
  EXPECT_EQ(planes["object"], (std::set<std::size_t>{0}));
}

TEST_P(HardSurveyOf, LaserReturnsLieOnTheSurfaces) {
  constexpr double kMinShare = 0.95;  // trees and narrow tops hide some
  const HardSurvey survey = hard_survey(kTrainingSeed, 20.0, GetParam());
  int n_lines = 0, n_seen = 0;
  for (const HardLine& line : survey.lines) {
    if (line.planes.empty() || length(line.segment) < 2.0) continue;
    ++n_lines;
    n_seen += *std::min_element(line.returns.begin(), line.returns.end()) >= 12 ? 1 : 0;
  }
  EXPECT_GE(n_seen, kMinShare * n_lines);
}

INSTANTIATE_TEST_SUITE_P(BothRenderers,
                         HardSurveyOf,
                         testing::Values(Renderer::kVillage, Renderer::kOther));

/// What a settlement was before it could be hard.
struct SettlementFingerprint {
  std::uint64_t seed;
  std::size_t faces, edges, ellipsoids;
  double sum_of_faces, sum_of_edges;
};

constexpr SettlementFingerprint kSettlement1{.seed = 1,
                                             .faces = 1075,
                                             .edges = 3153,
                                             .ellipsoids = 2851,
                                             .sum_of_faces = 23108.885969,
                                             .sum_of_edges = 62611.260831};
constexpr SettlementFingerprint kSettlement2{.seed = 2,
                                             .faces = 910,
                                             .edges = 2981,
                                             .ellipsoids = 3302,
                                             .sum_of_faces = 50179.505620,
                                             .sum_of_edges = 131380.724720};

TEST(MakeSettlement, IsHardOnlyIfAskedFor) {
  constexpr double kSumTol_m = 1e-3;  // rounding of some 1e4 coordinates
  for (const SettlementFingerprint& before : {kSettlement1, kSettlement2}) {
    const other::Scene scene = other::make_settlement(before.seed);
    double sum_of_faces = 0.0, sum_of_edges = 0.0;
    for (const other::Face& face : scene.faces) {
      for (const Eigen::Vector3d& x : face.corners) sum_of_faces += x.sum();
    }
    for (const other::Edge& edge : scene.edges) {
      sum_of_edges += edge.segment.start.sum() + 2.0 * edge.segment.end.sum();
    }
    EXPECT_EQ(scene.faces.size(), before.faces);
    EXPECT_EQ(scene.edges.size(), before.edges);
    EXPECT_EQ(scene.ellipsoids.size(), before.ellipsoids);
    EXPECT_NEAR(sum_of_faces, before.sum_of_faces, kSumTol_m);
    EXPECT_NEAR(sum_of_edges, before.sum_of_edges, kSumTol_m);
  }
}

}  // namespace
}  // namespace ridgeline::test
