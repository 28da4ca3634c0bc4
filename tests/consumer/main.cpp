// SPDX-License-Identifier: BSD-3-Clause
// Two images in memory -> 3D lines -> lines judged against laser points: what an outside program
// writes.
#include "evaluate/files/judge_files.h"
#include "evaluate/files/write_results.h"
#include "evaluate/judge/line_to_plane_evaluation.h"
#include "io/lines/write_lines.h"
#include "reconstruct/reconstruct.h"

#include <opencv2/imgproc.hpp>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <utility>
#include <vector>

namespace {

using ridgeline::ProjectionMatrix;
using ridgeline::evaluate::JudgedLine;
using ridgeline::reconstruct::ReconstructedLine;
using ridgeline::reconstruct::View;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double kEaves_m = 5.0, kRidge_m = 8.0, kHalfWidth_m = 6.0, kHalfLength_m = 10.0;

/// A roof whose ridge runs along y; the ground lies at 0.
double height_m(double x, double y) {
  if (std::abs(x) > kHalfWidth_m || std::abs(y) > kHalfLength_m) return 0.0;
  return kRidge_m - (kRidge_m - kEaves_m) * std::abs(x) / kHalfWidth_m;
}

/// Looks straight down from 100 m; a pixel of the ground is 0.1 m.
ProjectionMatrix camera_at(double x) {
  ProjectionMatrix p;
  p << 1000, 0, -300, 300 * 100 - 1000 * x, 0, -1000, -300, 300 * 100, 0, 0, -1, 100;
  return p;
}

View photograph(const char* id, double camera_x) {
  View view{id, camera_at(camera_x), cv::Mat(600, 600, CV_8UC1, cv::Scalar(60))};
  const auto fill = [&](const std::vector<Eigen::Vector3d>& corners, double grey) {
    constexpr int kBits = 8;  // of a pixel's fraction
    std::vector<cv::Point> polygon;
    for (const Eigen::Vector3d& corner : corners) {
      const Eigen::Vector2d x = (view.image_from_local * corner.homogeneous()).hnormalized();
      polygon.emplace_back(cvRound(x.x() * (1 << kBits)), cvRound(x.y() * (1 << kBits)));
    }
    cv::fillConvexPoly(view.image, polygon, cv::Scalar(grey), cv::LINE_AA, kBits);
  };
  const double w = kHalfWidth_m, l = kHalfLength_m;
  fill({{-w, -l, kEaves_m}, {0, -l, kRidge_m}, {0, l, kRidge_m}, {-w, l, kEaves_m}}, 200);
  fill({{0, -l, kRidge_m}, {w, -l, kEaves_m}, {w, l, kEaves_m}, {0, l, kRidge_m}}, 130);
  cv::GaussianBlur(view.image, view.image, {}, 0.7);
  return view;
}

Cloud::Ptr laser_points() {
  const Cloud::Ptr cloud(new Cloud);
  for (double x = -15.0; x <= 15.0; x += 0.3) {
    for (double y = -15.0; y <= 15.0; y += 0.3) {
      cloud->emplace_back(static_cast<float>(x), static_cast<float>(y),
                          static_cast<float>(height_m(x, y)));
    }
  }
  return cloud;
}

/// The same from files: what `ridgeline evaluate --lines lines.geojson --cloud cloud.xyz --out
/// judged` does.
std::size_t judge_from_files(const Cloud& cloud) {
  std::ofstream points("cloud.xyz");
  for (const pcl::PointXYZ& p : cloud) points << p.x << ' ' << p.y << ' ' << p.z << '\n';
  points.close();
  ridgeline::results::JudgeFilesOptions options;
  options.line_paths = {"lines.geojson"};
  options.cloud_paths = {"cloud.xyz"};
  options.patch_name = "house";
  ridgeline::results::RunRecord record("consumer");
  const auto judged = ridgeline::results::judge_files(options, record);
  const ridgeline::results::OutputFolder out("judged", options.line_paths);
  write_judged(judged, ridgeline::results::MapSchema::kPlain, out, "");
  write_tables(judged.evaluations, judged.truth, out);
  out.write_record(record.to_json());
  return judged.evaluations.front().lines.size();
}

}  // namespace

int main() {
  try {
    const auto found = ridgeline::reconstruct::reconstruct(
        {{photograph("left", -15.0), photograph("right", 15.0)}, {-2.0, 12.0}});
    std::vector<JudgedLine> lines;
    ridgeline::io::LineSet file;
    for (const ReconstructedLine& line : found.lines) {
      if (!line.segment_in_local) continue;
      JudgedLine& judged = lines.emplace_back();
      judged.id = std::to_string(lines.size());
      judged.segment = *line.segment_in_local;  // the frame's origin is (0, 0, 0) here
      file.lines.emplace_back().segment_in_world = judged.segment;
    }
    ridgeline::io::write_lines("lines.geojson", file, ridgeline::io::LineFormat::kGeoJson);
    ridgeline::evaluate::LineToPlaneEvaluation<pcl::PointXYZ> evaluation;
    evaluation.setInputCloud(laser_points());
    evaluation.setInputLines(lines);

    int n_right = 0;
    for (const auto& judged : evaluation.compute()) {
      std::printf("line %s: %s", judged.id.c_str(), ridgeline::evaluate::name(judged.status));
      if (judged.mean_distance_m) std::printf(", %.4f m", *judged.mean_distance_m);
      std::printf("\n");
      if (judged.mean_distance_m && *judged.mean_distance_m < 0.05) ++n_right;
    }
    if (judge_from_files(*laser_points()) != lines.size()) return 1;
    constexpr int kLinesAcrossTheBase = 3;  // the ridge and both eaves
    return n_right >= kLinesAcrossTheBase ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
