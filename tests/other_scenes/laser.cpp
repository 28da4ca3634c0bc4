// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/laser.h"

#include "tests/other_scenes/random_stream.h"

#include <array>
#include <cmath>

namespace ridgeline::other {
namespace {

using Eigen::Vector3d;

constexpr double kFlight_m = 600.0;
constexpr double kSigma_m = 0.034;

/// Appends what one pulse gives on its way from the aircraft to a place of the plan.
void add_returns(const RayTracer& tracer,
                 const Ray& pulse,
                 RandomStream& random,
                 std::vector<Vector3d>& points) {
  constexpr double kDeadTime_m = 0.3, kFar_m = 2.0 * kFlight_m, kPassShare = 0.5;
  double from_m = 0.0;
  while (const auto hit = tracer.first_hit(pulse, from_m, kFar_m)) {
    const double x_m = random.normal(kSigma_m);
    const double y_m = random.normal(kSigma_m);
    const double z_m = random.normal(kSigma_m);
    points.push_back(pulse.origin + hit->distance * pulse.direction + Vector3d(x_m, y_m, z_m));
    if (hit->ellipsoid < 0 || !random.chance(kPassShare)) return;
    from_m = hit->distance + kDeadTime_m;
  }
}

}  // namespace

std::vector<Vector3d> laser_points(const Scene& scene,
                                   const RayTracer& tracer,
                                   std::uint64_t seed,
                                   double density_per_m2) {
  constexpr double kBeyond_m = 8.0;
  constexpr std::array kStrips_m{-140.0, 90.0};  // y of the lines of flight
  constexpr double kJitter = 0.3;                // share of the spacing of pulses
  RandomStream random(seed + 4000U);
  const double half_m = scene.half_extent_m + kBeyond_m;
  const double spacing_m = std::sqrt(kStrips_m.size() / density_per_m2);
  const int n = static_cast<int>(2.0 * half_m / spacing_m);
  std::vector<Vector3d> points;
  for (const double strip_m : kStrips_m) {
    for (int i = 0; i < n * n; ++i) {
      const double x = (i % n + 0.5 + kJitter * random.uniform(-1.0, 1.0)) * spacing_m - half_m;
      const double y = (i / n + 0.5 + kJitter * random.uniform(-1.0, 1.0)) * spacing_m - half_m;
      const Vector3d origin(x, strip_m, kFlight_m);
      const Vector3d target = scene.on_ground({x, y});
      add_returns(tracer, {origin, (target - origin).normalized()}, random, points);
    }
  }
  return points;
}

}  // namespace ridgeline::other
