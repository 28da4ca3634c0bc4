// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/line_to_plane_evaluation.h"
#include "io/lines/read_lines.h"

#include <pcl/point_types.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <vector>

namespace {

using ridgeline::evaluate::JudgedLine;
using ridgeline::evaluate::LineEvaluation;

constexpr float kRoofM = 6.0F, kGroundM = 2.0F;

/// A flat roof for y < 5 m and the ground below it beyond, one point every 0.25 m.
pcl::PointCloud<pcl::PointXYZ>::Ptr flat_roof() {
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      const float x = 0.25F * static_cast<float>(i);
      const float y = 0.25F * static_cast<float>(j);
      cloud->emplace_back(x, y, y < 5.0F ? kRoofM : kGroundM);
    }
  }
  return cloud;
}

std::vector<JudgedLine> lines_of(const char* path) {
  std::vector<JudgedLine> lines;
  for (const ridgeline::io::Line& line : ridgeline::io::read_lines(path).lines) {
    JudgedLine& judged = lines.emplace_back();
    judged.id = line.id;
    judged.segment = line.segment_in_world;
  }
  return lines;
}

/// The eaves 0.1 m above the roof: its distance is known.
bool is_right(const LineEvaluation& judged) {
  constexpr double kExpectedM = 0.1, kToleranceM = 1e-3;
  std::printf("line %s: %s, %.4f m\n", judged.id.c_str(), ridgeline::evaluate::name(judged.status),
              judged.mean_distance_m);
  return std::abs(judged.mean_distance_m - kExpectedM) < kToleranceM;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 1;
  try {
    ridgeline::evaluate::LineToPlaneEvaluation<pcl::PointXYZ> evaluation;
    evaluation.setInputCloud(flat_roof());
    evaluation.setInputLines(lines_of(argv[1]));
    evaluation.setDistanceThreshold(0.1);
    const std::vector<LineEvaluation> judged = evaluation.compute();
    return judged.size() == 1 && is_right(judged.front()) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
