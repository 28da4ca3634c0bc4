// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/surface/surface.h"
#include "tests/reconstruct/support/owned_pair.h"
#include "tests/reconstruct/support/stereo_scene.h"

#include <cmath>
#include <functional>
#include <limits>

namespace ridgeline::test {

/// A pair of views of 32 m x 32 m of ground, 8 cm a pixel, and surfaces that they show.
class GableSurface {
 public:
  static constexpr int kSize_px = 400;
  static constexpr double kHalfLength_m = 10.0, kHalfWidth_m = 6.0, kRidge_m = 10.0;

  /// @param azimuth_deg  angle of the ridge to the x axis
  /// @param slope        slope of both roof planes, m/m
  explicit GableSurface(double azimuth_deg, double slope = 0.7)
      : along_(std::cos(azimuth_deg * kDegree), std::sin(azimuth_deg * kDegree)), slope_(slope) {
    cameras_ = scene_.cameras;
    for (ProjectionMatrix& camera : cameras_) {
      const Eigen::Vector2d centre = project(camera, Eigen::Vector3d::Zero().eval());
      for (const int axis : {0, 1})
        camera.row(axis) -= ((centre[axis] - kSize_px / 2.0) * camera.row(2)).eval();
    }
    rectification_ = *reconstruct::rectification(cameras_, {kSize_px, kSize_px});
  }

  [[nodiscard]] OwnedPair pair() const {
    return {
        {reconstruct::View{"left", cameras_[0], {}}, reconstruct::View{"right", cameras_[1], {}}},
        {-1.0, 20.0}};
  }
  [[nodiscard]] const reconstruct::Rectification& rectification() const { return rectification_; }

  [[nodiscard]] Segment3 ridge() const {
    const Eigen::Vector2d half = kHalfLength_m * along_;
    return {{-half.x(), -half.y(), kRidge_m}, {half.x(), half.y(), kRidge_m}};
  }

  /// The two roof planes, then the ground.
  [[nodiscard]] std::array<Plane3, 3> planes() const {
    const Eigen::Vector2d across = slope_ * Eigen::Vector2d(-along_.y(), along_.x());
    const Eigen::Vector3d top(0.0, 0.0, kRidge_m);
    return {Plane3(Eigen::Vector3d(across.x(), across.y(), 1.0).normalized(), top),
            Plane3(Eigen::Vector3d(-across.x(), -across.y(), 1.0).normalized(), top),
            Plane3(Eigen::Vector3d::UnitZ(), 0.0)};
  }

  /// The surface that the rectified left view shows, plus `noise_px` of each pixel.
  [[nodiscard]] reconstruct::Surface surface(
      const std::function<double(int row, int column)>& noise_px = {}) const {
    reconstruct::Surface surface{rectification_, cv::Mat(rectification_.size, CV_32F)};
    for (int row = 0; row < surface.disparity_px.rows; ++row) {
      for (int column = 0; column < surface.disparity_px.cols; ++column) {
        const double noise = noise_px ? noise_px(row, column) : 0.0;
        surface.disparity_px.at<float>(row, column) =
            static_cast<float>(disparity_px(Eigen::Vector2d(column, row)) + noise);
      }
    }
    return surface;
  }

 private:
  [[nodiscard]] double disparity_px(const Eigen::Vector2d& x_px) const {
    const Eigen::Vector3d ray =
        rectification_.point_in_local(x_px, 1.0) - rectification_.left_centre_m;
    const std::array<Plane3, 3> all = planes();
    double largest = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double d =
          -all[i].normal().dot(ray) / all[i].signedDistance(rectification_.left_centre_m);
      const Eigen::Vector3d x = rectification_.point_in_local(x_px, d);
      const double t = along_.dot(x.head<2>());
      const double s = Eigen::Vector2d(-along_.y(), along_.x()).dot(x.head<2>());
      const bool is_on_roof =
          std::abs(t) <= kHalfLength_m && std::abs(s) <= kHalfWidth_m && (i == 0) == (s >= 0.0);
      if (i == 2 || is_on_roof) largest = std::max(largest, d);
    }
    return largest;
  }

  StereoScene scene_;
  std::array<ProjectionMatrix, 2> cameras_;
  reconstruct::Rectification rectification_;
  Eigen::Vector2d along_;
  double slope_;
};

}  // namespace ridgeline::test
