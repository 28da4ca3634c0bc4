// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/transformed.h"
#include "reconstruct/scene/scene.h"
#include "tests/reconstruct/support/stereo_scene.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ridgeline::test {

/// Where a camera of a block is and how it is turned.
struct BlockCamera {
  std::string id;
  Eigen::Vector3d centre_m;
  double kappa_deg = 0.0;
  double tilt_deg = 0.0;  ///< about both axes
};

inline constexpr int kBlockImage_px = 5000;  // all views show what lies near the origin

/// 0.1 m on the ground from 800 m above it.
inline ProjectionMatrix block_camera(const BlockCamera& camera) {
  const double middle_px = 0.5 * kBlockImage_px;
  const Eigen::Matrix3d calibration =
      (Eigen::Matrix3d() << 8000, 0, middle_px, 0, 8000, middle_px, 0, 0, 1).finished();
  // x right, y down, seen from above
  const Eigen::Matrix3d nadir = Eigen::Vector3d(1, -1, -1).asDiagonal();
  const Eigen::Matrix3d cam_from_world =
      nadir * (Eigen::AngleAxisd(-camera.kappa_deg * kDegree, Eigen::Vector3d::UnitZ()) *
               Eigen::AngleAxisd(camera.tilt_deg * kDegree, Eigen::Vector3d::UnitY()) *
               Eigen::AngleAxisd(-0.6 * camera.tilt_deg * kDegree, Eigen::Vector3d::UnitX()))
                  .toRotationMatrix();
  ProjectionMatrix image_from_world;
  image_from_world << cam_from_world, -cam_from_world * camera.centre_m;
  return calibration * image_from_world;
}

/// A strip along x. Its epipolar lines are those of the x axis for every pair.
inline const std::vector<BlockCamera> kStrip{{"strip0", {0.0, 0.0, 800.0}, 0.0, 0.0},
                                             {"strip1", {208.0, 0.0, 800.0}, 0.0, 0.0},
                                             {"strip2", {-208.0, 0.0, 800.0}, 0.0, 0.0}};

/// A strip along x and one across it, a little out of level.
inline const std::vector<BlockCamera> kBlock{{"strip0", {0.0, 0.0, 800.0}, 0.0, 0.5},
                                             {"strip1", {208.0, 3.0, 803.0}, 1.0, -0.7},
                                             {"strip2", {-208.0, -4.0, 798.0}, -2.0, 0.4},
                                             {"cross0", {52.0, -104.0, 805.0}, 90.0, -0.3},
                                             {"cross1", {54.0, 104.0, 801.0}, 91.0, 0.6}};

/// The image of every view, held once: only its size is read, and thousands of scenes are made.
inline const cv::Mat& block_image() {
  static const cv::Mat image = cv::Mat::zeros(kBlockImage_px, kBlockImage_px, CV_32F);
  return image;
}

/// What the views of a block show of lines, without errors. Segment s of view v shows line
/// line_of[v][s].
struct BlockScene {
  reconstruct::Scene scene;
  std::vector<Segment3> lines;
  std::vector<std::vector<int>> line_of;

  explicit BlockScene(const std::vector<BlockCamera>& cameras = kBlock) : line_of(cameras.size()) {
    scene.height_range_in_local_m = {-10.0, 25.0};
    for (const BlockCamera& camera : cameras) {
      scene.views.push_back({camera.id, block_camera(camera), block_image()});
    }
  }

  /// Adds a line that all views show. Views in `hidden_in` do not.
  int add(const Segment3& line, std::initializer_list<std::size_t> hidden_in = {}) {
    const auto number = static_cast<int>(lines.size());
    lines.push_back(line);
    for (std::size_t v = 0; v < scene.views.size(); ++v) {
      if (std::ranges::find(hidden_in, v) == hidden_in.end()) show(v, number, 0.0, 1.0);
    }
    return number;
  }

  /// Adds a segment of a view that shows a part of a line.
  void show(
      std::size_t view, int line, double from, double to, const Noise& noise = scaled({}, 0.4)) {
    const Segment3& whole = lines[static_cast<std::size_t>(line)];
    const Segment2 image = project(scene.views[view].image_from_local,
                                   Segment3{point_at(whole, from), point_at(whole, to)});
    EdgeSegment edge;
    edge.line = exact(image, noise);
    edge.in_image = image;
    scene.views[view].segments.push_back(edge);
    line_of[view].push_back(line);
  }

  /// Turns the order of each view's segments around by another number, so that a line has other
  /// numbers in other views.
  void mix() {
    for (std::size_t v = 0; v < scene.views.size(); ++v) {
      auto& segments = scene.views[v].segments;
      const auto by = static_cast<std::ptrdiff_t>(v % std::max<std::size_t>(1, segments.size()));
      std::rotate(segments.begin(), segments.begin() + by, segments.end());
      std::rotate(line_of[v].begin(), line_of[v].begin() + by, line_of[v].end());
    }
  }

  [[nodiscard]] int segment_of(std::size_t view, int line) const {
    const auto found = std::ranges::find(line_of[view], line);
    return static_cast<int>(found - line_of[view].begin());
  }

  [[nodiscard]] int line_at(const Observation& s) const {
    return line_of[s.view][static_cast<std::size_t>(s.segment)];
  }

  [[nodiscard]] std::vector<ProjectionMatrix> cameras() const {
    return transformed(scene.views, &reconstruct::View::image_from_local);
  }

  /// The true matches of a pair of views.
  [[nodiscard]] MatchedPair matches(const ViewPair& views) const {
    MatchedPair pair{views, {}};
    for (std::size_t i = 0; i < line_of[views.base].size(); ++i) {
      const int right = segment_of(views.search, line_of[views.base][i]);
      if (right < static_cast<int>(line_of[views.search].size()))
        pair.matches.push_back({static_cast<int>(i), right});
    }
    return pair;
  }

  /// The observations of a track by the ids of their views, which do not depend on the order of the
  /// views.
  [[nodiscard]] std::set<std::pair<std::string, int>> observations_by_id(const Track& track) const {
    std::set<std::pair<std::string, int>> all;
    for (const Observation& s : track.observations) all.emplace(scene.views[s.view].id, s.segment);
    return all;
  }
};

/// The block with its views in another order.
inline BlockScene with_views(const BlockScene& block, std::span<const std::size_t> order) {
  BlockScene reordered = block;
  for (std::size_t v = 0; v < order.size(); ++v) {
    reordered.scene.views[v] = block.scene.views[order[v]];
    reordered.line_of[v] = block.line_of[order[v]];
  }
  return reordered;
}

/// A block over eaves and ridges of houses: level lines and verges in all directions, 16 m apart.
inline BlockScene block_of_lines(const std::vector<BlockCamera>& cameras = kBlock) {
  BlockScene block(cameras);
  Random random(201);
  for (int row = -2; row <= 2; ++row) {
    for (int column = -2; column <= 2; ++column) {
      const Eigen::Vector3d middle(16.0 * column, 16.0 * row, random.uniform(0.0, 12.0));
      const double azimuth = random.uniform(0.0, std::numbers::pi);
      const double rise_m = block.lines.size() % 2 == 0 ? 0.0 : random.uniform(-2.0, 2.0);
      const Eigen::Vector3d half(5.0 * std::cos(azimuth), 5.0 * std::sin(azimuth), 0.5 * rise_m);
      block.add({middle - half, middle + half});
    }
  }
  block.mix();
  return block;
}

}  // namespace ridgeline::test
