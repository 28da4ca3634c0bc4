// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"
#include "io/cloud/point_cloud.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <memory>

namespace ridgeline::simulate {

/// An airborne laser scanner over a scene: parallel flight strips with a rotating mirror whose scan
/// lines and pulses are equally spaced on the ground.
struct AlsOptions {
  std::uint64_t seed = 1;
  double density_per_m2 = 5.0;           ///< mean pulses per m^2 of the plan, all strips together
  double height_above_ground_m = 700.0;  ///< flying height, 100 to 5000
  double half_scan_angle_deg = 20.0;     ///< to each side of nadir, 1 to 40
  double strip_overlap = 0.3;            ///< as a share of the swath, 0 to 0.9
  double strip_azimuth_deg = 10.0;       ///< angle of the flight lines to the x axis
  double range_sigma_m = 0.034;          ///< noise along the beam
  double cross_sigma_m = 0.034;  ///< noise across the beam, per axis. If range_sigma_m equals it,
                                 ///< noise normal to any surface also has this standard deviation
  double footprint_m = 0.0;  ///< diameter of the beam at the ground; hits are distributed over it
  double strip_offset_sigma_m = 0.0;  ///< systematic shift of each strip, per axis
  int max_returns = 5;                ///< returns per pulse, 1 to 15
  double outlier_share = 2e-4;        ///< share of the pulses, for birds and multipath; class 7
  double withheld_share = 0.0;        ///< share of the returns flagged as withheld
};

/// Keeps the data shared by all scans of a scene, so that a large cloud can be generated window by
/// window.
class AlsScanner {
 public:
  /// Keeps a reference to the scene. Throws std::invalid_argument for an option outside its range.
  AlsScanner(const SyntheticScene& scene, const AlsOptions& options);
  ~AlsScanner();
  AlsScanner(const AlsScanner&) = delete;
  AlsScanner& operator=(const AlsScanner&) = delete;
  AlsScanner(AlsScanner&&) noexcept;
  AlsScanner& operator=(AlsScanner&&) noexcept;

  /// The returns of the whole flight within a window of the plan (local), in order of strip, scan
  /// line, pulse and return. source_id: strip, from 1. Classes: 1 cars, fences, garden walls; 2
  /// ground; 5 vegetation; 6 buildings; 7 outliers. Byte-identical for any number of threads;
  /// disjoint windows have no return in common.
  [[nodiscard]] io::PointCloud scan(const Eigen::AlignedBox2d& window_m) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Scans the whole extent.
io::PointCloud scan_als(const SyntheticScene& scene, const AlsOptions& options);

}  // namespace ridgeline::simulate
