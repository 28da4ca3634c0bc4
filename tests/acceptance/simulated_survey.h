// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/als.h"
#include "apps/simulate/truth.h"
#include "apps/simulate/village.h"
#include "evaluate/judge/judge_lines.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::test {

/// A village with its laser cloud, free of the outliers that read_cloud() drops by their class.
struct SimulatedSurvey {
  simulate::SyntheticScene scene;
  std::vector<Eigen::Vector3d> points;
  std::vector<simulate::TruthLine> truth;
};

inline SimulatedSurvey simulated_survey(std::uint64_t seed, double density_per_m2) {
  constexpr std::uint8_t kLowNoise = 7;
  SimulatedSurvey survey;
  simulate::VillageOptions village;
  village.seed = seed;
  survey.scene = simulate::make_village(village);
  simulate::AlsOptions als;
  als.seed = 1000 + seed;
  als.density_per_m2 = density_per_m2;
  const io::PointCloud cloud = simulate::scan_als(survey.scene, als);
  survey.truth = simulate::observe_lines(survey.scene, cloud);
  for (const io::CloudPoint& p : cloud.points) {
    if (p.classification != kLowNoise) survey.points.emplace_back(p.x, p.y, p.z);
  }
  return survey;
}

/// All true lines, moved; then everything, points as well, is shifted.
inline std::vector<evaluate::JudgedResult> judge_survey(
    const SimulatedSurvey& survey,
    const Eigen::Vector3d& move_m,
    const Eigen::Vector3d& shift_of_all_m = Eigen::Vector3d::Zero()) {
  const auto position = [&](std::size_t i) {
    return Eigen::Vector3d(survey.points[i] + shift_of_all_m);
  };
  const auto grid = evaluate::PointGrid::build(survey.points.size(), position);
  const Eigen::Vector3d move_and_shift_m = move_m + shift_of_all_m;
  std::vector<evaluate::JudgedLine> lines;
  for (std::size_t i = 0; i < survey.scene.lines.size(); ++i) {
    const Segment3& segment = survey.scene.lines[i].segment;
    evaluate::JudgedLine& line = lines.emplace_back();
    line.id = std::to_string(i);
    line.segment = {segment.start + move_and_shift_m, segment.end + move_and_shift_m};
  }
  return evaluate::judge_lines(grid, lines, {});
}

/// Whether the laser saw what a judge needs: a dozen returns on each plane of the line.
inline bool has_lidar(const simulate::TruthLine& line) {
  constexpr int kMinReturns = 12;
  return std::all_of(line.plane_returns.begin(), line.plane_returns.end(),
                     [](int returns) { return returns >= kMinReturns; });
}

}  // namespace ridgeline::test
