// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/als.h"
#include "apps/simulate/random.h"
#include "apps/simulate/scene.h"

#include <Eigen/Geometry>

namespace ridgeline::simulate {

/// Outliers lie up to this height above the ground.
inline constexpr double kMaxOutlierHeightM = 60.0;

/// One laser pulse, from the aircraft towards a point on the mean terrain. Local metres.
struct Pulse {
  Eigen::Vector3d origin_m;
  Eigen::Vector3d target_m;
};

/// The flight path and the aim of the pulses. Frame `flight`: f along the strips, a across, origin
/// in the middle of the scene.
class FlightPlan {
 public:
  FlightPlan(const SyntheticScene& scene, const AlsOptions& options);

  [[nodiscard]] int num_strips() const { return num_strips_; }
  [[nodiscard]] int num_lines() const { return num_lines_; }  ///< scan lines per strip

  struct PulseRange {
    int first = 0;
    int last = 0;  ///< one past the end
  };
  /// The pulses of a scan line that may produce a return in the window.
  [[nodiscard]] PulseRange pulses_near(int strip,
                                       int line,
                                       const Eigen::AlignedBox2d& window) const;

  /// A pulse by its numbers; its aim has a small random jitter.
  [[nodiscard]] Pulse pulse(int strip, int line, int pulse, Random& random) const;

 private:
  [[nodiscard]] double strip_centre_a_m(int strip) const;
  [[nodiscard]] double mean_coverage(const Eigen::Vector2d& extent_m) const;

  Eigen::Matrix2d local_from_flight_;
  Eigen::Vector2d centre_m_;
  PlanFunction terrain_;
  double height_m_;
  double footprint_m_;
  double swath_m_;
  double strip_spacing_m_;
  double pulse_spacing_m_ = 1.0;
  double half_length_m_ = 0.0;  // half the length of a strip
  double margin_m_ = 0.0;       // plan distance between the aim of a pulse and its returns
  int num_strips_ = 1;
  int num_lines_ = 1;
};

}  // namespace ridgeline::simulate
