// SPDX-License-Identifier: BSD-3-Clause
// Real airborne laser scans of IGN France (Licence Ouverte / Etalab 2.0): ridges moved farther are
// judged worse, by as much as they were moved.

#include "io/cloud/read_cloud.h"
#include "tests/acceptance/judge_cloud.h"
#include "tests/acceptance/roof_ridges.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <string>

namespace ridgeline::test {
namespace {

using evaluate::LineEvaluation;
using evaluate::Status;

constexpr std::array<double, 4> kMoves_m = {0.0, 0.1, 0.3, 1.0};

std::vector<Eigen::Vector3d> building_points(const io::PointCloud& cloud) {
  constexpr std::uint8_t kBuilding = 6;
  std::vector<Eigen::Vector3d> points;
  for (const io::CloudPoint& p : cloud.points) {
    if (p.classification == kBuilding) points.emplace_back(p.x, p.y, p.z);
  }
  return points;
}

std::vector<Segment3> raised(const std::vector<Segment3>& segments, double up_m) {
  const Eigen::Vector3d up = up_m * Eigen::Vector3d::UnitZ();
  std::vector<Segment3> moved;
  for (const Segment3& segment : segments) moved.push_back({segment.start + up, segment.end + up});
  return moved;
}

struct Judgement {
  int n_evaluated = 0;
  double rms_m = 0.0;
  double mean_normal_z = 0.0;  ///< of the judging planes
};

Judgement summarise(const std::vector<LineEvaluation>& lines) {
  Judgement judgement;
  double sum_m2 = 0.0, sum_normal_z = 0.0;
  int n_planes = 0;
  for (const LineEvaluation& line : lines) {
    if (line.status != Status::kEvaluated) continue;
    ++judgement.n_evaluated;
    sum_m2 += *line.mean_distance_m * *line.mean_distance_m;
    for (const evaluate::JudgingPlane& judging : line.planes) {
      sum_normal_z += judging.plane.normal().z();
      ++n_planes;
    }
  }
  judgement.rms_m = std::sqrt(sum_m2 / judgement.n_evaluated);
  judgement.mean_normal_z = sum_normal_z / n_planes;
  return judgement;
}

struct Tile {
  const char* file;
  int min_ridges;
};

std::ostream& operator<<(std::ostream& stream, const Tile& tile) { return stream << tile.file; }

class IgnTile : public ::testing::TestWithParam<Tile> {};

TEST_P(IgnTile, RanksRidgesByHowFarTheyWereRaised) {
  constexpr double kTolerance_m = 0.03;  // a plane of a whole roof to the one beside the line
  const std::filesystem::path path =
      std::filesystem::path(test::shared_data_dir()) / "ign" / GetParam().file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path.parent_path() << " is absent";
  const io::PointCloud cloud = io::read_cloud({path.string()});
  const std::vector<Segment3> ridges = roof_ridges(building_points(cloud));
  const int n_ridges = static_cast<int>(ridges.size());
  RecordProperty("ridges", n_ridges);
  ASSERT_GE(n_ridges, GetParam().min_ridges);
  const evaluate::PointGrid grid = grid_of(cloud);
  double last_rms_m = -1.0;
  for (const double move_m : kMoves_m) {
    const Judgement judgement = summarise(judge_segments(grid, raised(ridges, move_m)));
    RecordProperty("raised_" + std::to_string(move_m) + "_rms_m", std::to_string(judgement.rms_m));
    EXPECT_EQ(judgement.n_evaluated, n_ridges) << move_m;
    EXPECT_GT(judgement.rms_m, last_rms_m) << move_m;
    EXPECT_NEAR(judgement.rms_m, move_m * judgement.mean_normal_z, kTolerance_m) << move_m;
    last_rms_m = judgement.rms_m;
  }
}

// The least number of ridges that the independent finder must give: its thresholds were chosen on
// these two tiles, where it finds 5 and 1.
INSTANTIATE_TEST_SUITE_P(Tiles,
                         IgnTile,
                         ::testing::Values(Tile{"test_data_77060_627760_LA93_IGN69.laz", 5},
                                           Tile{"test_data_77055_627755_LA93_IGN69.laz", 1}));

}  // namespace
}  // namespace ridgeline::test
