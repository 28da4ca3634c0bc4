// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/rectification.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

/// The matrix from rays to pixels of a camera, scaled so that its third row gives the depth,
/// positive in front of the camera.
Eigen::Matrix3d image_from_ray(const ProjectionMatrix& camera) {
  const Eigen::Matrix3d m = camera.leftCols<3>();
  return m * ((m.determinant() < 0.0 ? -1.0 : 1.0) / m.row(2).norm());
}

Eigen::Vector3d viewing_direction(const ProjectionMatrix& camera) {
  return image_from_ray(camera).row(2).transpose();
}

std::array<Eigen::Vector2d, 4> corners_of(const cv::Size& size) {
  const double right = size.width - 1.0;
  const double bottom = size.height - 1.0;
  return {{{0.0, 0.0}, {right, 0.0}, {0.0, bottom}, {right, bottom}}};
}

/// Area of the pixel at x after applying the homography.
double area_of_pixel(const Eigen::Matrix3d& h, const Eigen::Vector2d& x) {
  const double w = h.row(2).dot(x.homogeneous());
  return std::abs(h.determinant() / (w * w * w));
}

/// Whether the whole image lies on one side of the horizon of a homography.
bool is_one_sided(const Eigen::Matrix3d& h, const cv::Size& size) {
  const double sign = h.row(2).dot(Eigen::Vector3d(0.0, 0.0, 1.0));
  return std::ranges::all_of(corners_of(size), [&](const Eigen::Vector2d& corner) {
    return sign * h.row(2).dot(corner.homogeneous()) > 0.0;
  });
}

}  // namespace

Eigen::Vector2d Rectification::rectified(const Eigen::Vector3d& x_in_local) const {
  const Eigen::Vector3d in_camera = rectified_from_local * (x_in_local - left_centre_m);
  return focal_px * in_camera.hnormalized() + principal_point_px;
}

Eigen::Vector3d Rectification::point_in_local(const Eigen::Vector2d& x_px, double d_px) const {
  const Eigen::Vector2d reduced = x_px - principal_point_px;
  const Eigen::Vector3d ray(reduced.x(), reduced.y(), focal_px);
  return left_centre_m + rectified_from_local.transpose() * ray * (base_m / d_px);
}

double Rectification::disparity_at_height_px(const Eigen::Vector2d& x_px,
                                             double z_in_local_m) const {
  const double rise_m = (point_in_local(x_px, 1.0) - left_centre_m).z();  // for a disparity of 1
  return rise_m / (z_in_local_m - left_centre_m.z());
}

std::optional<Rectification> rectification(const std::array<ProjectionMatrix, 2>& cameras,
                                           const cv::Size& size_px) {
  constexpr double kMinSine = 0.2;
  // Growth of the image's area. It is 2 for an image rotated by 45 degrees.
  constexpr double kMaxGrowth = 4.0;
  Rectification r;
  r.left_centre_m = projection_centre(cameras[0]).hnormalized();
  const Eigen::Vector3d base =
      Eigen::Vector3d(projection_centre(cameras[1]).hnormalized()) - r.left_centre_m;
  r.base_m = base.norm();
  const Eigen::Vector3d x = base / r.base_m;
  const Eigen::Vector3d view = viewing_direction(cameras[0]) + viewing_direction(cameras[1]);
  const Eigen::Vector3d across = view.cross(x);
  if (!(across.norm() > kMinSine * view.norm())) return std::nullopt;
  const Eigen::Vector3d y = across.normalized();
  r.rectified_from_local << x.transpose(), y.transpose(), x.cross(y).transpose();

  const auto unscaled = [&](std::size_t j) -> Eigen::Matrix3d {
    return r.rectified_from_local * image_from_ray(cameras[j]).inverse();
  };
  const Eigen::Vector2d middle(0.5 * (size_px.width - 1.0), 0.5 * (size_px.height - 1.0));
  r.focal_px = 1.0 / std::sqrt(area_of_pixel(unscaled(0), middle));
  Eigen::Vector2d low = Eigen::Vector2d::Constant(HUGE_VAL);
  Eigen::Vector2d high = -low;
  for (const Eigen::Vector2d& corner : corners_of(size_px)) {
    const Eigen::Vector2d seen =
        r.focal_px * Eigen::Vector3d(unscaled(0) * corner.homogeneous()).hnormalized();
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
  }
  // The area is not finite if a corner lies on the horizon of the base.
  const double area_px = (high - low).prod();
  if (!(area_px < kMaxGrowth * size_px.area()) || !is_one_sided(unscaled(0), size_px))
    return std::nullopt;
  r.principal_point_px = -low;
  r.size = {static_cast<int>(std::ceil(high.x() - low.x())) + 1,
            static_cast<int>(std::ceil(high.y() - low.y())) + 1};
  Eigen::Matrix3d calibration;
  calibration << r.focal_px, 0.0, r.principal_point_px.x(),  //
      0.0, r.focal_px, r.principal_point_px.y(),             //
      0.0, 0.0, 1.0;
  for (const std::size_t j : {0U, 1U}) r.rectified_from_ideal[j] = calibration * unscaled(j);
  return r;
}

Eigen::Vector2d image_from_ideal(const PixelMap& ideal_from_image, const Eigen::Vector2d& ideal) {
  constexpr int kMaxSteps = 20;
  constexpr double kClose_px = 1e-3;
  if (!ideal_from_image) return ideal;
  Eigen::Vector2d x = ideal;
  for (int step = 0; step < kMaxSteps; ++step) {
    const auto back = ideal_from_image(x);
    if (!back) break;
    const Eigen::Vector2d off = ideal - *back;
    x += off;
    if (off.norm() < kClose_px) return x;
  }
  return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
}

cv::Mat image_from_rectified(const Eigen::Matrix3d& rectified_from_ideal,
                             const PixelMap& ideal_from_image,
                             const cv::Rect& tile) {
  constexpr int kCell_px = 8;
  const Eigen::Matrix3d ideal_from_rectified = rectified_from_ideal.inverse();
  const int columns = (tile.width + kCell_px - 1) / kCell_px + 1;
  const int rows = (tile.height + kCell_px - 1) / kCell_px + 1;
  cv::Mat corners(rows, columns, CV_32FC2);
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const Eigen::Vector2d x(tile.x + c * kCell_px, tile.y + r * kCell_px);
      const Eigen::Vector2d seen = image_from_ideal(
          ideal_from_image, Eigen::Vector3d(ideal_from_rectified * x.homogeneous()).hnormalized());
      corners.at<cv::Vec2f>(r, c) = cv::Vec2f(cv::Vec2d(seen.x(), seen.y()));
    }
  }
  cv::Mat map(tile.size(), CV_32FC2);
  for (int y = 0; y < tile.height; ++y) {
    const int r = y / kCell_px;
    const float down = static_cast<float>(y % kCell_px) / kCell_px;
    for (int x = 0; x < tile.width; ++x) {
      const int c = x / kCell_px;
      const float right = static_cast<float>(x % kCell_px) / kCell_px;
      const auto along = [&](int row) {
        return corners.at<cv::Vec2f>(row, c) * (1.0F - right) +
               corners.at<cv::Vec2f>(row, c + 1) * right;
      };
      map.at<cv::Vec2f>(y, x) = along(r) * (1.0F - down) + along(r + 1) * down;
    }
  }
  return map;
}

}  // namespace ridgeline::reconstruct
