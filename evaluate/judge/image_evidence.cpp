// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/image_evidence.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/epipolar.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {
namespace {

Eigen::Vector3d at_height(const ImageEvidence& images, const Eigen::Vector2d& x_px, double z_m) {
  return point_on_plane(images.base().image_from_local, x_px,
                        Plane3(Eigen::Vector3d::UnitZ(), -z_m));
}

Segment3 at_height(const ImageEvidence& images, double z_m) {
  const Segment2& base = images.base().px;
  return {at_height(images, base.start, z_m), at_height(images, base.end, z_m)};
}

/// The course of a ray through the range of heights: its position in plan at each height.
struct ImageRay {
  Eigen::Vector2d at_zero, per_metre;
  [[nodiscard]] Eigen::Vector2d at(double z_m) const { return at_zero + z_m * per_metre; }
};

ImageRay ray_of(const ImageEvidence& images, const Eigen::Vector2d& x_px) {
  const auto [low, high] = images.height_range_m;
  const Eigen::Vector2d x_low = at_height(images, x_px, low).head<2>();
  const Eigen::Vector2d x_high = at_height(images, x_px, high).head<2>();
  const Eigen::Vector2d per_metre = (x_high - x_low) / (high - low);
  return {x_low - low * per_metre, per_metre};
}

/// A radius in plan that holds two to three points, from the density around `x`.
double search_radius_m(const PointSearch& search, const Eigen::Vector2d& x) {
  constexpr double kAround_m = 4.0;
  constexpr double kPointsWanted = 2.5;
  constexpr double kMinRadius_m = 0.3;
  constexpr double kMaxRadius_m = 1.0;
  const auto n = static_cast<double>(search.count_within(x, kAround_m));
  return std::clamp(kAround_m * std::sqrt(kPointsWanted / std::max(n, 1.0)), kMinRadius_m,
                    kMaxRadius_m);
}

/// Height of the surface at the fraction `s` of the segment.
struct HeightSample {
  double s, z_m;
};

/// The heights at which rays through `n_samples` points of the base segment first meet the cloud
/// from above. Each is the height of the highest point within `radius_m` of the ray.
std::vector<HeightSample> first_hits(const PointSearch& search,
                                     const ImageEvidence& images,
                                     int n_samples,
                                     double radius_m) {
  const Segment2& base = images.base().px;
  const auto [low, high] = images.height_range_m;
  const auto share = [&](int i) { return (i + 0.5) / n_samples; };
  std::vector<ImageRay> rays;
  rays.reserve(static_cast<std::size_t>(n_samples));
  for (int i = 0; i < n_samples; ++i) {
    rays.push_back(ray_of(images, base.start + share(i) * (base.end - base.start)));
  }
  std::vector<double> highest_m(rays.size(), -HUGE_VAL);
  const auto meet = [&, low = low, high = high](const PointSearch::Point& p) {
    const double z_m = p.x.z();
    const Eigen::Vector2d x = p.x.head<2>();
    if (!(z_m >= low && z_m <= high)) return;
    // at any given height, all rays pass between the outermost ones
    if (distance(Segment2{rays.front().at(z_m), rays.back().at(z_m)}, x) > radius_m) return;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (z_m <= highest_m[i]) continue;
      if ((rays[i].at(z_m) - x).squaredNorm() <= radius_m * radius_m) highest_m[i] = z_m;
    }
  };
  // At a given height, a ray lies up to half a spacing from the next segment of the sweep.
  const double reach_m = 1.5 * radius_m;
  for (const Segment2& segment : plan_sweep(images, radius_m)) {
    search.visit_near(segment, reach_m, meet);
  }
  std::vector<HeightSample> hits;
  for (int i = 0; i < n_samples; ++i) {
    if (std::isfinite(highest_m[i])) hits.push_back({share(i), highest_m[i]});
  }
  return hits;
}

struct HeightLine {
  double z0_m, slope_m;  ///< z = z0 + s * slope
  [[nodiscard]] double at(double s) const { return z0_m + s * slope_m; }
};

std::vector<HeightSample> agreeing(const std::vector<HeightSample>& samples,
                                   const HeightLine& line) {
  constexpr double kAgree_m = 0.3;  // rise of the steepest roof over half a search radius
  std::vector<HeightSample> kept;
  for (const HeightSample& sample : samples) {
    if (std::abs(sample.z_m - line.at(sample.s)) <= kAgree_m) kept.push_back(sample);
  }
  return kept;
}

HeightLine regression(const std::vector<HeightSample>& samples) {
  double mean_s = 0.0;
  double mean_z = 0.0;
  for (const HeightSample& p : samples) {
    mean_s += p.s / static_cast<double>(samples.size());
    mean_z += p.z_m / static_cast<double>(samples.size());
  }
  double ss = 0.0;
  double sz = 0.0;
  for (const HeightSample& p : samples) {
    ss += (p.s - mean_s) * (p.s - mean_s);
    sz += (p.s - mean_s) * (p.z_m - mean_z);
  }
  const double slope = ss > 0.0 ? sz / ss : 0.0;
  return {mean_z - slope * mean_s, slope};
}

/// The samples that agree with a line through two of them, for the line with which the most agree.
std::vector<HeightSample> consensus(const std::vector<HeightSample>& samples) {
  // fraction of the segment: closer samples provide no information about its slope
  constexpr double kMinSeparation = 0.25;
  std::vector<HeightSample> best;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t k = i + 1; k < samples.size(); ++k) {
      const double ds = samples[k].s - samples[i].s;
      if (ds < kMinSeparation) continue;
      const double slope = (samples[k].z_m - samples[i].z_m) / ds;
      std::vector<HeightSample> kept =
          agreeing(samples, {samples[i].z_m - slope * samples[i].s, slope});
      if (kept.size() > best.size()) best = std::move(kept);
    }
  }
  return best;
}

/// Mean of the squared distances of both ends of `x` from the straight line of `observation`,
/// pixels squared.
double across_px2(const ImageObservation& observation, const Segment3& x) {
  const Eigen::Vector2d along = (observation.px.end - observation.px.start).normalized();
  double sum = 0.0;
  for (const Eigen::Vector3d& end : {x.start, x.end}) {
    const Eigen::Vector2d off = project(observation.image_from_local, end) - observation.px.start;
    sum += 0.5 * std::pow(off.x() * along.y() - off.y() * along.x(), 2);
  }
  return sum;
}

/// Sum over the observations from `first` on, except those in the base image.
double chi_square_from(const ImageEvidence& images,
                       std::size_t first,
                       const Segment3& x,
                       double sigma_px) {
  constexpr double kMaxChiSquare = 25.0;
  double sum = 0.0;
  for (std::size_t i = first; i < images.observations.size(); ++i) {
    const ImageObservation& observation = images.observations[i];
    if (observation.image_from_local == images.base().image_from_local) continue;
    const double chi_square = across_px2(observation, x) / (sigma_px * sigma_px);
    sum += chi_square < kMaxChiSquare ? chi_square : kMaxChiSquare;  // also for NaN
  }
  return sum;
}

}  // namespace

std::optional<Segment3> monoplot(const PointSearch& search, const ImageEvidence& images) {
  constexpr double kSpacing_m = 0.25;
  constexpr double kMinShare = 0.5;  // of the samples that must agree with the line found
  const Segment3 midway =
      at_height(images, 0.5 * (images.height_range_m[0] + images.height_range_m[1]));
  if (!all_finite(midway)) return std::nullopt;
  const int n_samples = std::clamp(static_cast<int>(length(midway) / kSpacing_m), 4, 40);
  const double radius_m = search_radius_m(search, midpoint(plan(midway)));
  const std::vector<HeightSample> inliers =
      consensus(first_hits(search, images, n_samples, radius_m));
  if (static_cast<double>(inliers.size()) < kMinShare * n_samples) return std::nullopt;
  const HeightLine line = regression(inliers);
  const Segment2& base = images.base().px;
  const Segment3 seen{at_height(images, base.start, line.at(0.0)),
                      at_height(images, base.end, line.at(1.0))};
  if (!all_finite(seen) || !(length(plan(seen)) > 0.0)) return std::nullopt;
  return seen;
}

bool has_independent_observation(const ImageEvidence& images) {
  constexpr double kMinAngle_rad = 10.0 * kRadPerDeg;
  const auto centre = [&](std::size_t i) -> Eigen::Vector3d {
    return projection_centre(images.observations[i].image_from_local).hnormalized();
  };
  const Eigen::Vector3d base = centre(1) - centre(0);
  for (std::size_t i = 2; i < images.observations.size(); ++i) {
    const Eigen::Vector3d to_other = centre(i) - centre(0);
    if (to_other.norm() > 0.0 && acute_angle_rad(base, to_other) >= kMinAngle_rad) return true;
  }
  return false;
}

double observations_chi_square(const ImageEvidence& images, const Plane3& plane, double sigma_px) {
  const ImageObservation& base = images.base();
  return chi_square_from(images, 1,
                         {point_on_plane(base.image_from_local, base.px.start, plane),
                          point_on_plane(base.image_from_local, base.px.end, plane)},
                         sigma_px);
}

double observations_chi_square(const ImageEvidence& images, double sigma_px) {
  const ImageObservation& other = images.other();
  const Eigen::Vector3d join = other.px.start.homogeneous().cross(other.px.end.homogeneous());
  const Eigen::Vector4d viewing = other.image_from_local.transpose() * join;
  const Plane3 plane(viewing.head<3>().normalized(), viewing.w() / viewing.head<3>().norm());
  const ImageObservation& base = images.base();
  return chi_square_from(images, 2,
                         {point_on_plane(base.image_from_local, base.px.start, plane),
                          point_on_plane(base.image_from_local, base.px.end, plane)},
                         sigma_px);
}

std::vector<Segment2> plan_sweep(const ImageEvidence& images, double spacing_m) {
  constexpr int kMaxSteps = 1000;  // a ray near the horizon would need more
  const auto [low, high] = images.height_range_m;
  const Segment3 on_ground = at_height(images, low);
  const Segment2 first = plan(on_ground);
  const Segment2 last = plan(at_height(images, high));
  const double way_m = std::max((last.start - first.start).norm(), (last.end - first.end).norm());
  if (!in_range(on_ground) || !(way_m < kMaxSteps * spacing_m)) return {};
  const int steps = std::max(1, static_cast<int>(std::ceil(way_m / spacing_m)));
  std::vector<Segment2> sweep;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    sweep.push_back(
        {first.start + t * (last.start - first.start), first.end + t * (last.end - first.end)});
  }
  return sweep;
}

}  // namespace ridgeline::evaluate
