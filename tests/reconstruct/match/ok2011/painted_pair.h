// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/scene/scene.h"
#include "tests/reconstruct/match/ok2011/stereo_pair.h"
#include "tests/reconstruct/support/owned_pair.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace ridgeline::test {

/// Images of roofs of one plane over level ground, with textures fixed to the surfaces and black
/// walls, and segments as an extraction would find them.
class PaintedPair {
 public:
  struct Roof {
    double west, south, east, north, height_m;
    double rise = 0.0;  ///< rise to the north; `height_m` is that of the south edge

    [[nodiscard]] double height_at(double y_m) const { return height_m + rise * (y_m - south); }
  };
  static constexpr int kSize_px = 400;

  explicit PaintedPair(std::vector<Roof> roofs, double base_m = StereoPair::kBase_m)
      : cameras_(0.0, base_m), roofs_(std::move(roofs)) {
    // the plan's origin falls into the middle of both images
    ProjectionMatrix shift = ProjectionMatrix::Zero();
    for (ProjectionMatrix* camera : {&cameras_.left, &cameras_.right}) {
      shift = *camera;
      for (const int row : {0, 1}) shift.row(row) += 0.5 * kSize_px * camera->row(2);
      *camera = shift;
    }
    for (const std::size_t i : {0U, 1U}) {
      views[i].image_from_local = i == 0 ? cameras_.left : cameras_.right;
      views[i].image = paint(views[i].image_from_local, i == 0 ? 0.0 : base_m);
    }
  }

  /// Adds what each image shows of a line; returns its index, the same in both.
  int add_line(const Segment3& in_left, const Segment3& in_right) {
    add_segment(0, in_left);
    add_segment(1, in_right);
    return static_cast<int>(views[0].segments.size()) - 1;
  }
  int add_line(const Segment3& line) { return add_line(line, line); }

  void add_segment(std::size_t view, const Segment3& line) {
    views[view].segments.push_back(
        with_flanks(edge(project(views[view].image_from_local, line)), views[view].image));
  }

  /// The four edges of a roof.
  void add_outline(const Roof& r) {
    const double south = r.height_at(r.south);
    const double north = r.height_at(r.north);
    add_line({{r.west, r.south, south}, {r.east, r.south, south}});
    add_line({{r.east, r.south, south}, {r.east, r.north, north}});
    add_line({{r.east, r.north, north}, {r.west, r.north, north}});
    add_line({{r.west, r.north, north}, {r.west, r.south, south}});
  }

  [[nodiscard]] OwnedPair pair() const { return {views, heights_m}; }
  [[nodiscard]] reconstruct::SearchedPair searched() const {
    return {
        views[0], views[1],
        reconstruct::StereoSearch(views[0].image_from_local, views[1].image_from_local, heights_m)};
  }

  std::array<reconstruct::View, 2> views;
  std::array<double, 2> heights_m{-5.0, 30.0};

 private:
  /// Smooth noise in [0, 1] of period 0.25 m and more, from hashed lattice values.
  static double noise(double x, double y, std::uint32_t salt) {
    const auto lattice = [salt](std::int64_t i, std::int64_t k) {
      std::uint64_t h = static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15ULL ^
                        static_cast<std::uint64_t>(k) * 0xC2B2AE3D27D4EB4FULL ^ salt;
      h ^= h >> 29U;
      h *= 0xBF58476D1CE4E5B9ULL;
      h ^= h >> 32U;
      return static_cast<double>(h & 0xFFFFU) / 65535.0;
    };
    double sum = 0.0;
    for (const double period_m : {0.25, 1.0}) {
      const double u = x / period_m;
      const double v = y / period_m;
      const auto i = static_cast<std::int64_t>(std::floor(u));
      const auto k = static_cast<std::int64_t>(std::floor(v));
      const double fu = u - std::floor(u);
      const double fv = v - std::floor(v);
      sum += 0.5 * ((1 - fv) * ((1 - fu) * lattice(i, k) + fu * lattice(i + 1, k)) +
                    fv * ((1 - fu) * lattice(i, k + 1) + fu * lattice(i + 1, k + 1)));
    }
    return sum;
  }

  [[nodiscard]] float colour_along(double camera_x_m, const Eigen::Vector2d& on_ground) const {
    for (std::size_t r = 0; r < roofs_.size(); ++r) {
      const Roof& roof = roofs_[r];
      // share of the ray from the camera to the ground at which it meets the plane of the roof
      const double share = (StereoPair::kHeight_m - roof.height_at(0.0)) /
                           (StereoPair::kHeight_m + roof.rise * on_ground.y());
      const double x = camera_x_m + share * (on_ground.x() - camera_x_m);
      const double y = share * on_ground.y();
      if (x > roof.west && x < roof.east && y > roof.south && y < roof.north) {
        return static_cast<float>(0.55 + 0.2 * noise(x, y, static_cast<std::uint32_t>(r) + 7U));
      }
    }
    for (const Roof& roof : roofs_) {
      if (on_ground.x() > roof.west && on_ground.x() < roof.east && on_ground.y() > roof.south &&
          on_ground.y() < roof.north) {
        return 0.05F;  // a wall hides this ground
      }
    }
    return static_cast<float>(0.25 + 0.2 * noise(on_ground.x(), on_ground.y(), 1U));
  }

  [[nodiscard]] cv::Mat paint(const ProjectionMatrix& camera, double camera_x_m) const {
    // plane-to-image homography of the ground, z = 0
    Eigen::Matrix3d image_from_ground;
    image_from_ground << camera.col(0), camera.col(1), camera.col(3);
    const Eigen::Matrix3d ground_from_image = image_from_ground.inverse();
    cv::Mat image(kSize_px, kSize_px, CV_32FC1);
    for (int row = 0; row < kSize_px; ++row) {
      for (int column = 0; column < kSize_px; ++column) {
        const Eigen::Vector3d x(column, row, 1.0);
        image.at<float>(row, column) =
            colour_along(camera_x_m, (ground_from_image * x).hnormalized());
      }
    }
    return image;
  }

  static EdgeSegment with_flanks(EdgeSegment segment, const cv::Mat& image) {
    const Segment2 s = segment.in_image;
    const Eigen::Vector2d u = (s.end - s.start).normalized();
    const Eigen::Vector2d n(-u.y(), u.x());
    const auto mean = [&](double side) {
      double sum = 0.0;
      int count = 0;
      for (double t = 0.05; t < 1.0; t += 0.05) {
        for (double offset = 2.0; offset <= 5.0; offset += 1.0) {
          const Eigen::Vector2d x = (1.0 - t) * s.start + t * s.end + side * offset * n;
          const auto column = static_cast<int>(std::lround(x.x()));
          const auto row = static_cast<int>(std::lround(x.y()));
          if (column < 0 || row < 0 || column >= kSize_px || row >= kSize_px) continue;
          sum += image.at<float>(row, column);
          ++count;
        }
      }
      return static_cast<float>(count > 0 ? sum / count : 0.0);
    };
    const float left = mean(-1.0);
    const float right = mean(1.0);
    segment.left.grey = segment.left.colour[0] = left;
    segment.right.grey = segment.right.colour[0] = right;
    if (right >= left) return segment;
    std::swap(segment.left, segment.right);  // the brighter side is on the right
    segment.line.segment = {s.end, s.start};
    segment.in_image = {s.end, s.start};
    return segment;
  }

  StereoPair cameras_;
  std::vector<Roof> roofs_;
};

}  // namespace ridgeline::test
