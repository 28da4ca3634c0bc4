// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/reconstruct/support/owned_pair.h"
#include "tests/reconstruct/support/stereo_scene.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace ridgeline::test {

/// A painted face z = height + slope (x - middle of its plan) over a rectangle of the plan.
struct PaintedFace {
  Eigen::AlignedBox2d plan{};
  double height_m = 0.0;
  double slope = 0.0;
  double contrast = 1.0;  ///< contrast of the paint; 0: a plain face
  double brighter = 0.0;  ///< by how much of the grey range it is brighter than ground

  [[nodiscard]] double height_at(const Eigen::Vector2d& x) const {
    return height_m + slope * (x.x() - plan.center().x());
  }
};

/// Grey values 0 to 1 without a direction of their own, about a pixel of StereoScene in size.
inline double paint(double x_m, double y_m) {
  const auto lattice = [](std::int64_t i, std::int64_t k) {
    auto h = static_cast<std::uint64_t>(i * 73856093 ^ k * 19349663) * 0x9E3779B97F4A7C15U;
    h ^= h >> 29U;
    return static_cast<double>((h * 0xBF58476D1CE4E5B9U) >> 40U) / static_cast<double>(1U << 24U);
  };
  constexpr double kCell_m = 0.2;
  const double u = x_m / kCell_m;
  const double v = y_m / kCell_m;
  const auto i = static_cast<std::int64_t>(std::floor(u));
  const auto k = static_cast<std::int64_t>(std::floor(v));
  const double a = u - static_cast<double>(i);
  const double b = v - static_cast<double>(k);
  return (1.0 - b) * ((1.0 - a) * lattice(i, k) + a * lattice(i + 1, k)) +
         b * ((1.0 - a) * lattice(i, k + 1) + a * lattice(i + 1, k + 1));
}

/// Images of faces over painted ground at z = 0: the pair of StereoScene, cut out around the
/// origin.
struct PaintedRoofs {
  std::vector<PaintedFace> faces;
  int size_px = 400;
  double ground_contrast = 1.0;
  double right_turn_rad = 0.0;  ///< turn of the right image in its plane

  [[nodiscard]] OwnedPair pair() const {
    const StereoScene scene;
    OwnedPair result;
    result.height_range_in_local_m = {-3.0, 12.0};
    for (std::size_t j = 0; j < 2; ++j) {
      const double half = 0.5 * size_px;
      const Eigen::Vector2d middle = project(scene.cameras[j], Eigen::Vector3d(0.0, 0.0, 0.0));
      const Eigen::Rotation2Dd turn(j == 1 ? right_turn_rad : 0.0);
      Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
      turned.topLeftCorner<2, 2>() = turn.toRotationMatrix();
      turned.topRightCorner<2, 1>() = Eigen::Vector2d(half, half) - turn * middle;
      reconstruct::View& view = result.views[j];
      view.image_from_local = turned * scene.cameras[j];
      view.image = photograph(view.image_from_local);
    }
    return result;
  }

  /// The point that a camera sees at a pixel.
  [[nodiscard]] Eigen::Vector3d seen(const ProjectionMatrix& camera,
                                     const Eigen::Vector2d& x) const {
    const Eigen::Vector3d centre = projection_centre(camera).hnormalized();
    const Eigen::Vector3d ray = camera.leftCols<3>().inverse() * x.homogeneous();
    Eigen::Vector3d best = centre - centre.z() / ray.z() * ray;  // the ground
    for (const PaintedFace& face : faces) {
      const double t =
          (face.height_m + face.slope * (centre.x() - face.plan.center().x()) - centre.z()) /
          (ray.z() - face.slope * ray.x());
      const Eigen::Vector3d on_face = centre + t * ray;
      if (face.plan.contains(on_face.head<2>()) && on_face.z() > best.z()) best = on_face;
    }
    return best;
  }

 private:
  [[nodiscard]] double grey_at(const Eigen::Vector3d& x) const {
    PaintedFace at{.contrast = ground_contrast};
    for (const PaintedFace& face : faces) {
      if (face.plan.contains(x.head<2>()) && std::abs(face.height_at(x.head<2>()) - x.z()) < 1e-6) {
        at = face;
        break;
      }
    }
    return 0.5 + at.brighter + 0.6 * at.contrast * (paint(x.x(), x.y()) - 0.5);
  }

  [[nodiscard]] cv::Mat photograph(const ProjectionMatrix& camera) const {
    cv::Mat image(size_px, size_px, CV_32F);
    for (int row = 0; row < size_px; ++row) {
      for (int column = 0; column < size_px; ++column) {
        const Eigen::Vector3d x = seen(camera, Eigen::Vector2d(column, row));
        image.at<float>(row, column) = static_cast<float>(grey_at(x));
      }
    }
    return image;
  }
};

}  // namespace ridgeline::test
