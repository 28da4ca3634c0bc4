// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"
#include "tests/support/random.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <numbers>

namespace ridgeline::test {

inline constexpr double kDegree = std::numbers::pi / 180.0;

/// Two cameras like those of the published test: 800 m above ground, 8 cm on the ground,
/// base/height 0.26, base along x, a few degrees of tilt. Object points lie around the origin.
struct StereoScene {
  std::array<ProjectionMatrix, 2> cameras;

  explicit StereoScene(double tilt_deg = 2.0) {
    const Eigen::Matrix3d calibration =
        (Eigen::Matrix3d() << 10000, 0, 3840, 0, 10000, 6912, 0, 0, 1).finished();
    // x right, y down, seen from above
    const Eigen::Matrix3d nadir = Eigen::Vector3d(1, -1, -1).asDiagonal();
    for (std::size_t j = 0; j < 2; ++j) {
      const double side = j == 0 ? -1.0 : 1.0;
      const Eigen::Vector3d centre(side * 104.0, 10.0 * side, 800.0 + 3.0 * side);
      const Eigen::Matrix3d tilt =
          (Eigen::AngleAxisd(side * tilt_deg * kDegree, Eigen::Vector3d::UnitY()) *
           Eigen::AngleAxisd(0.7 * tilt_deg * kDegree, Eigen::Vector3d::UnitX()))
              .toRotationMatrix();
      cameras[j] << nadir * tilt, -(nadir * tilt) * centre;
      cameras[j] = (calibration * cameras[j]).eval();
    }
  }

  [[nodiscard]] std::array<Segment2, 2> images(const Segment3& s) const {
    return {project(cameras[0], s), project(cameras[1], s)};
  }

  /// The point at a height that the left camera sees at a pixel.
  [[nodiscard]] Eigen::Vector3d at_height(const Eigen::Vector2d& x_left, double z_m) const {
    const Eigen::Matrix3d inverse = cameras[0].leftCols<3>().inverse();
    const Eigen::Vector3d centre = -inverse * cameras[0].col(3);
    const Eigen::Vector3d direction = inverse * x_left.homogeneous();
    return centre + (z_m - centre.z()) / direction.z() * direction;
  }

  /// Unit direction of the epipolar line through a pixel of the left image.
  [[nodiscard]] Eigen::Vector2d epipolar_direction(const Eigen::Vector2d& x_left) const {
    const Eigen::Vector3d epipole = cameras[0] * projection_centre(cameras[1]);
    return (epipole.head<2>() - epipole.z() * x_left).normalized();
  }

  /// Where the left camera sees the origin.
  [[nodiscard]] Eigen::Vector2d left_centre() const {
    return project(cameras[0], Eigen::Vector3d(Eigen::Vector3d::Zero()));
  }
};

/// A segment about `x_left` in the left image, there at the angle theta to the epipolar line, with
/// ends at two heights.
struct SegmentSpec {
  Eigen::Vector2d x_left;
  double theta_rad = 0.0;
  double length_px = 100.0;
  double start_z_m = 0.0;
  double end_z_m = 0.0;
};

inline Segment3 make_segment(const StereoScene& scene, const SegmentSpec& spec) {
  const Eigen::Vector2d half =
      0.5 * spec.length_px *
      (Eigen::Rotation2Dd(spec.theta_rad) * scene.epipolar_direction(spec.x_left));
  return {scene.at_height(spec.x_left - half, spec.start_z_m),
          scene.at_height(spec.x_left + half, spec.end_z_m)};
}

/// Standard deviations of a segment.
struct Noise {
  double q_px = 0.25;
  double phi_rad = 0.25 * 0.0245;  ///< q sqrt(12) / (sqrt(2) 100): edge pixels of a 100 px segment
  double e_px = 1.0;
};

/// The noise with every standard deviation multiplied.
inline Noise scaled(const Noise& noise, double factor) {
  return {factor * noise.q_px, factor * noise.phi_rad, factor * noise.e_px};
}

/// A segment without error that states the given precision.
inline UncertainSegment2 exact(const Segment2& s, const Noise& noise = {}) {
  return {s, midpoint(s), noise.q_px, noise.phi_rad, noise.e_px};
}

/// A segment with errors drawn from the precision that it states.
inline UncertainSegment2 noisy(const Segment2& s, const Noise& noise, Random& random) {
  const Eigen::Vector2d direction = s.end - s.start;
  const Eigen::Vector2d across = Eigen::Vector2d(-direction.y(), direction.x()).normalized();
  const Eigen::Vector2d centroid = midpoint(s) + random.normal(noise.q_px) * across;
  const Eigen::Vector2d along =
      Eigen::Rotation2Dd(random.normal(noise.phi_rad)) * direction.normalized();
  const double half = 0.5 * direction.norm();
  const double start = -half + random.normal(noise.e_px);
  const double end = half + random.normal(noise.e_px);
  return {{centroid + start * along, centroid + end * along},
          centroid,
          noise.q_px,
          noise.phi_rad,
          noise.e_px};
}

/// The 99 % interval of the mean of n chi-square variables with k degrees of freedom has this half
/// width about k, for large n.
inline double chi_square_mean_band(double degrees_of_freedom, int n) {
  return 2.576 * std::sqrt(2.0 * degrees_of_freedom / n);
}

}  // namespace ridgeline::test
