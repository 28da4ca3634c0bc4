// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/judge_lines.h"
#include "io/cloud/point_cloud.h"

#include <string>
#include <utility>
#include <vector>

namespace ridgeline::test {

inline evaluate::PointGrid grid_of(const io::PointCloud& cloud) {
  return evaluate::PointGrid::build(cloud.points.size(), [&](std::size_t i) {
    const io::CloudPoint& p = cloud.points[i];
    return Eigen::Vector3d(p.x, p.y, p.z);
  });
}

/// Default options.
inline std::vector<evaluate::LineEvaluation> judge_each(
    const evaluate::PointGrid& grid, const std::vector<evaluate::JudgedLine>& lines) {
  std::vector<evaluate::LineEvaluation> evaluations;
  for (evaluate::JudgedResult& result : evaluate::judge_lines(grid, lines, {})) {
    evaluations.push_back(std::move(result.evaluation));
  }
  return evaluations;
}

/// Default options; ids are the numbers of the segments (local).
inline std::vector<evaluate::LineEvaluation> judge_segments(const evaluate::PointGrid& grid,
                                                            const std::vector<Segment3>& segments) {
  std::vector<evaluate::JudgedLine> lines;
  for (const Segment3& segment : segments) {
    evaluate::JudgedLine& line = lines.emplace_back();
    line.id = std::to_string(lines.size() - 1);
    line.segment = segment;
  }
  return judge_each(grid, lines);
}

}  // namespace ridgeline::test
