// SPDX-License-Identifier: BSD-3-Clause
// A cloud of PCL -> lines judged by a kd-tree of PCL -> a PCD file whose points are labelled by
// plane.
//
//   pcl_lines [OUT.pcd]
#include "evaluate/judge/line_to_plane_evaluation.h"

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace {

using ridgeline::evaluate::JudgedLine;
using ridgeline::evaluate::LineEvaluation;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using LabelledCloud = pcl::PointCloud<pcl::PointXYZL>;
using Evaluation = ridgeline::evaluate::LineToPlaneEvaluation<pcl::PointXYZ>;

constexpr double kEaves_m = 5.0, kRidge_m = 8.0, kHalfWidth_m = 6.0, kHalfLength_m = 10.0;
constexpr double kTooHigh_m = 0.25;  // the fault of one line

/// A gabled roof whose ridge runs along y, on level ground.
Cloud::Ptr house() {
  auto cloud = std::make_shared<Cloud>();
  for (float x = -15.0F; x <= 15.0F; x += 0.4F) {
    for (float y = -15.0F; y <= 15.0F; y += 0.4F) {
      const bool on_roof = std::abs(x) <= kHalfWidth_m && std::abs(y) <= kHalfLength_m;
      const double z = kRidge_m - (kRidge_m - kEaves_m) * std::abs(x) / kHalfWidth_m;
      cloud->emplace_back(x, y, on_roof ? static_cast<float>(z) : 0.0F);
    }
  }
  return cloud;
}

JudgedLine line_along_y(const char* id, double x, double z) {
  JudgedLine line;
  line.id = id;
  line.segment = {{x, -kHalfLength_m, z}, {x, kHalfLength_m, z}};
  return line;
}

std::vector<JudgedLine> lines_of_the_house() {
  return {line_along_y("ridge", 0.0, kRidge_m), line_along_y("eave", kHalfWidth_m, kEaves_m),
          line_along_y("eave too high", -kHalfWidth_m, kEaves_m + kTooHigh_m)};
}

/// Label: id of the plane that a point belongs to; 0: none.
LabelledCloud labelled(const Cloud& cloud,
                       const Evaluation& evaluation,
                       const std::vector<LineEvaluation>& judged) {
  LabelledCloud result;
  for (const pcl::PointXYZ& p : cloud) result.push_back(pcl::PointXYZL(p.x, p.y, p.z, 0));
  for (std::size_t line = 0; line < judged.size(); ++line) {
    const std::vector<pcl::Indices> inliers = evaluation.getInliers(line);
    for (std::size_t plane = 0; plane < inliers.size(); ++plane) {
      for (const pcl::index_t i : inliers[plane]) {
        result[static_cast<std::size_t>(i)].label =
            static_cast<std::uint32_t>(judged[line].planes[plane].id);
      }
    }
  }
  return result;
}

/// Whether the lines have the distances, and the file the planes, of the house.
bool is_right(const std::vector<LineEvaluation>& judged, const std::string& path) {
  constexpr double kTol_m = 0.005;
  const double too_high_m =
      kTooHigh_m * kHalfWidth_m / std::hypot(kHalfWidth_m, kRidge_m - kEaves_m);
  const std::vector<double> expected_m{0.0, 0.0, too_high_m};
  for (std::size_t i = 0; i < judged.size(); ++i) {
    if (judged[i].status != ridgeline::evaluate::Status::kEvaluated) return false;
    if (std::abs(*judged[i].mean_distance_m - expected_m[i]) > kTol_m) return false;
  }
  LabelledCloud read;
  if (pcl::io::loadPCDFile(path, read) != 0) return false;
  std::map<std::uint32_t, int> points_of_label;
  for (const pcl::PointXYZL& p : read) ++points_of_label[p.label];
  points_of_label.erase(0);
  return points_of_label.size() == 2;  // both sides of the roof, each judging two lines
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Cloud::Ptr cloud = house();  // or pcl::io::loadPCDFile("cloud.pcd", *cloud)
    const std::string out = argc > 1 ? argv[1] : "planes.pcd";

    Evaluation evaluation;
    evaluation.setInputCloud(cloud);
    evaluation.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
    evaluation.setInputLines(lines_of_the_house());
    const std::vector<LineEvaluation> judged = evaluation.compute();
    for (const LineEvaluation& line : judged) {
      std::printf("%-14s %-10s %zu planes", line.id.c_str(), ridgeline::evaluate::name(line.status),
                  line.planes.size());
      if (line.mean_distance_m) std::printf(" %7.4f m", *line.mean_distance_m);
      std::printf("\n");
    }
    pcl::io::savePCDFileBinary(out, labelled(*cloud, evaluation, judged));
    return is_right(judged, out) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
