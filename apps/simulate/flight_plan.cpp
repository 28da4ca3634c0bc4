// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/flight_plan.h"

#include "reconstruct/geometry/degrees.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ridgeline::simulate {
namespace {

/// Largest vertical distance of anything in the scene from the mean terrain.
double relief_m(const SyntheticScene& scene) {
  double relief = kMaxOutlierHeightM;
  for (const Eigen::Vector3d& x : scene.mesh.vertices) {
    relief = std::max(relief, std::abs(x.z() - scene.mean_terrain(x.head<2>())));
  }
  return relief;
}

/// Maximum plan distance of a return from the aim of its pulse, due to the inclination of the beam
/// and the tails of the errors.
double plan_margin_m(const SyntheticScene& scene, const AlsOptions& options) {
  constexpr double kTail = 7.0;  // number of standard deviations that no draw exceeds in practice
  const double noise_m =
      options.range_sigma_m + options.cross_sigma_m + options.strip_offset_sigma_m;
  return relief_m(scene) * std::tan(kRadPerDeg * options.half_scan_angle_deg) + kTail * noise_m +
         options.footprint_m + 1.0;
}

}  // namespace

FlightPlan::FlightPlan(const SyntheticScene& scene, const AlsOptions& options)
    : local_from_flight_(
          Eigen::Rotation2Dd(kRadPerDeg * options.strip_azimuth_deg).toRotationMatrix()),
      centre_m_(0.5 * scene.extent_m),
      terrain_(scene.mean_terrain),
      height_m_(options.height_above_ground_m),
      footprint_m_(options.footprint_m),
      swath_m_(2.0 * height_m_ * std::tan(kRadPerDeg * options.half_scan_angle_deg)),
      strip_spacing_m_(swath_m_ * (1.0 - options.strip_overlap)),
      margin_m_(plan_margin_m(scene, options)) {
  half_length_m_ = 0.5 * scene.extent_m.norm() + margin_m_;
  // one strip more than needed, so that each scene is seen from at least two sides
  num_strips_ = static_cast<int>(std::ceil(scene.extent_m.norm() / strip_spacing_m_)) + 1;
  pulse_spacing_m_ = std::sqrt(mean_coverage(scene.extent_m) / options.density_per_m2);
  num_lines_ = static_cast<int>(std::ceil(2.0 * half_length_m_ / pulse_spacing_m_));
}

double FlightPlan::strip_centre_a_m(int strip) const {
  return (static_cast<double>(strip) - 0.5 * (num_strips_ - 1)) * strip_spacing_m_;
}

double FlightPlan::mean_coverage(const Eigen::Vector2d& extent_m) const {
  constexpr int kGrid = 64;
  int covered = 0;
  for (int i = 0; i < kGrid * kGrid; ++i) {
    const int row = i / kGrid;
    const Eigen::Vector2d cell(0.5 + i % kGrid, 0.5 + row);
    const Eigen::Vector2d x = cell.cwiseProduct(extent_m) / kGrid;
    const double a = (local_from_flight_.transpose() * (x - centre_m_)).y();
    for (int strip = 0; strip < num_strips_; ++strip) {
      covered += std::abs(a - strip_centre_a_m(strip)) <= 0.5 * swath_m_ ? 1 : 0;
    }
  }
  return static_cast<double>(covered) / (kGrid * kGrid);
}

FlightPlan::PulseRange FlightPlan::pulses_near(int strip,
                                               int line,
                                               const Eigen::AlignedBox2d& window) const {
  const double margin_m = margin_m_ + 2.0 * pulse_spacing_m_;
  Eigen::AlignedBox2d box;  // the window in the flight frame
  for (int corner = 0; corner < 4; ++corner) {
    const Eigen::Vector2d x = window.corner(static_cast<Eigen::AlignedBox2d::CornerType>(corner));
    box.extend(local_from_flight_.transpose() * (x - centre_m_));
  }
  const double f = -half_length_m_ + line * pulse_spacing_m_;
  if (f < box.min().x() - margin_m || f > box.max().x() + margin_m) return {};
  const double first_a = strip_centre_a_m(strip) - 0.5 * swath_m_;
  const int count = static_cast<int>(swath_m_ / pulse_spacing_m_);
  const auto index = [&](double a) {
    return static_cast<int>(std::clamp((a - first_a) / pulse_spacing_m_, 0.0, 1.0 * count));
  };
  return {index(box.min().y() - margin_m), index(box.max().y() + margin_m)};
}

Pulse FlightPlan::pulse(int strip, int line, int pulse, Random& random) const {
  constexpr double kJitter = 0.1;  // share of the spacing, because mirror and clock are not perfect
  const double share = (pulse + 0.5) * pulse_spacing_m_ / swath_m_;
  const auto jitter = [&] { return kJitter * pulse_spacing_m_ * random.normal(); };
  // the aircraft advances by one line while the mirror sweeps
  const double f = -half_length_m_ + (line + share) * pulse_spacing_m_;
  const double a = strip_centre_a_m(strip) + (share - 0.5) * swath_m_;
  const double spread = 0.5 * footprint_m_ * std::sqrt(random.uniform());
  const double phase = 2.0 * std::numbers::pi * random.uniform();
  const Eigen::Vector2d aim{f + jitter() + spread * std::cos(phase),
                            a + jitter() + spread * std::sin(phase)};
  const Eigen::Vector2d target = local_from_flight_ * aim + centre_m_;
  const Eigen::Vector2d aircraft =
      local_from_flight_ * Eigen::Vector2d(f, strip_centre_a_m(strip)) + centre_m_;
  return {.origin_m = {aircraft.x(), aircraft.y(), terrain_(aircraft) + height_m_},
          .target_m = {target.x(), target.y(), terrain_(target)}};
}

}  // namespace ridgeline::simulate
