// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/candidate_planes.h"

#include "evaluate/judge/ledge_search.h"
#include "evaluate/judge/plan_hull.h"
#include "evaluate/judge/zone_cells.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace ridgeline::evaluate {
namespace {

/// Mean and root mean square of the residuals of the seeds.
std::pair<double, double> residuals(std::span<const ZonePoint> seeds, const Plane3& plane) {
  double sum = 0.0;
  double squares = 0.0;
  for (const ZonePoint& p : seeds) {
    const double d = plane.signedDistance(p.x);
    sum += d;
    squares += d * d;
  }
  const auto n = static_cast<double>(seeds.size());
  return {sum / n, std::sqrt(squares / n)};
}

/// Whether the wider fit still describes the surface at the line: it must not have tilted towards a
/// neighbouring facet or followed a curved slope.
bool fits_locally(const PlaneFit& wide, const FoundPlane& local, const JudgeOptions& options) {
  const auto [mean, rms] = residuals(local.inliers, wide.plane);
  const double n = local.fit.n;
  const double sigma_m = std::max(local.fit.sigma0_m, options.lidar_sigma_m);
  const double slack_m = 0.05 * options.inlier_distance_m;
  return std::abs(mean) <= 3.0 * sigma_m / std::sqrt(n) + slack_m &&
         rms <= sigma_m * (1.0 + 3.0 / std::sqrt(2.0 * n)) + slack_m;
}

/// The found plane extended over the zone, or the plane as found if the wider one does not fit at
/// the line.
CandidatePlane extend(const FoundPlane& found,
                      const ZoneCells& cells,
                      const JudgeOptions& options) {
  constexpr int kPasses = 2;
  CandidatePlane plane{.fit = found.fit, .inliers = found.inliers, .beside = {}};
  for (int pass = 0; pass < kPasses; ++pass) {
    std::vector<ZonePoint> inliers =
        cells.connected_inliers(found.inliers, plane.fit.plane, options.inlier_distance_m);
    const std::optional<PlaneFit> fit = fit_plane(positions(inliers));
    if (!fit || !fits_locally(*fit, found, options)) break;
    plane.fit = *fit;
    plane.inliers = std::move(inliers);
  }
  trim(plane, options.inlier_distance_m);
  return plane;
}

/// Whether the plane is a slice of a canopy. A solid surface hides what is below it; a canopy does
/// not, so there are many returns below the slice.
bool lets_laser_through(const FoundPlane& plane,
                        std::span<const ZonePoint> zone,
                        const JudgeOptions& options) {
  constexpr double kMaxShareBelow = 0.5;  // the hull of an L-shaped roof includes some ground
  const PlanHull hull(plane.inliers);
  const auto below = std::count_if(zone.begin(), zone.end(), [&](const ZonePoint& p) {
    return plane.fit.plane.signedDistance(p.x) < -options.inlier_distance_m &&
           hull.contains({p.s, p.t});
  });
  return static_cast<double>(below) >
         kMaxShareBelow *
             static_cast<double>(static_cast<std::size_t>(below) + plane.inliers.size());
}

/// Two candidates are the same plane if they share half of the smaller one's points.
bool same_plane(const CandidatePlane& a, const CandidatePlane& b) {
  std::size_t shared = 0;
  auto ia = a.inliers.begin();
  auto ib = b.inliers.begin();
  while (ia != a.inliers.end() && ib != b.inliers.end()) {
    if (ia->rank == ib->rank) {
      ++shared;
      ++ia;
      ++ib;
    } else if (ia->rank < ib->rank) {
      ++ia;
    } else {
      ++ib;
    }
  }
  return 2 * shared >= std::min(a.inliers.size(), b.inliers.size());
}

/// Whether `small` is not a separate surface, but a few points left over beside a much larger plane
/// and almost on it.
bool shadows(const CandidatePlane& large,
             const CandidatePlane& small,
             const JudgeOptions& options) {
  constexpr double kLarger = 2.0;
  const double n = static_cast<double>(small.inliers.size());
  if (static_cast<double>(large.inliers.size()) < kLarger * n) return false;
  double offset_m = 0.0;
  for (const ZonePoint& p : small.inliers) offset_m += large.fit.plane.absDistance(p.x) / n;
  return offset_m < 2.0 * options.inlier_distance_m;
}

void drop_shadows(std::vector<CandidatePlane>& candidates, const JudgeOptions& options) {
  std::vector<CandidatePlane> kept;
  for (const CandidatePlane& plane : candidates) {
    const bool shadowed = std::any_of(candidates.begin(), candidates.end(), [&](const auto& other) {
      return shadows(other, plane, options);
    });
    if (!shadowed) kept.push_back(plane);
  }
  candidates = std::move(kept);
}

/// The points of a strip t_from <= t <= t_to that is slightly longer than the line: for a short
/// line there would otherwise be too few points.
std::vector<ZonePoint> strip_of(std::span<const ZonePoint> zone,
                                const Footprint& footprint,
                                double t_from,
                                double t_to) {
  constexpr double kSearchEnd_m = 1.0;
  std::vector<ZonePoint> points;
  for (const ZonePoint& p : zone) {
    if (p.t >= t_from && p.t <= t_to && p.s >= -kSearchEnd_m &&
        p.s <= footprint.length_m + kSearchEnd_m) {
      points.push_back(p);
    }
  }
  return points;
}

std::vector<FoundPlane> planes_beside(std::span<const ZonePoint> zone,
                                      const Footprint& footprint,
                                      const JudgeOptions& options,
                                      const PointNormals& normals) {
  const double gap = options.side_gap_m;
  const double far = options.corridor_half_width_m;
  std::vector<FoundPlane> found;
  for (const auto& [from, to] : {std::pair(gap, far), std::pair(-far, -gap)}) {
    for (FoundPlane& plane : search_planes(strip_of(zone, footprint, from, to), options, normals)) {
      found.push_back(std::move(plane));
    }
  }
  return found;
}

/// Adds a plane, or replaces a smaller part of the same plane by it.
void unite(CandidatePlane plane, std::vector<CandidatePlane>& candidates) {
  std::sort(plane.inliers.begin(), plane.inliers.end(),
            [](const ZonePoint& a, const ZonePoint& b) { return a.rank < b.rank; });
  const auto same = std::find_if(candidates.begin(), candidates.end(),
                                 [&](const auto& other) { return same_plane(plane, other); });
  if (same == candidates.end()) {
    candidates.push_back(std::move(plane));
  } else if (same->inliers.size() < plane.inliers.size()) {
    *same = std::move(plane);
  }
}

/// Whether the plane is too narrow for its tilt to be determined. search_ledge() assumes such a
/// strip to be level across the line.
bool is_strip(const FoundPlane& plane) {
  constexpr double kMinWidth_m = 0.6;
  // a uniform distribution of this width has the variance width^2 / 12
  return 12.0 * plane.fit.spread_m2.y() / plane.fit.n < kMinWidth_m * kMinWidth_m;
}

/// The points of the whole corridor that no candidate explains: a dormer may have too few points on
/// either side of a line, but enough on both.
std::vector<ZonePoint> unexplained(std::span<const ZonePoint> zone,
                                   std::span<const CandidatePlane> candidates,
                                   const Footprint& footprint,
                                   const JudgeOptions& options) {
  std::vector<ZonePoint> rest =
      strip_of(zone, footprint, -options.corridor_half_width_m, options.corridor_half_width_m);
  std::erase_if(rest, [&](const ZonePoint& p) {
    return std::any_of(candidates.begin(), candidates.end(), [&](const CandidatePlane& plane) {
      return plane.fit.plane.absDistance(p.x) <= options.inlier_distance_m;
    });
  });
  return rest;
}

}  // namespace

std::vector<CandidatePlane> candidate_planes(std::span<const ZonePoint> zone,
                                             const Footprint& footprint,
                                             const JudgeOptions& options,
                                             const PointNormals& normals) {
  constexpr double kMinCellSize_m = 0.7;
  constexpr double kMaxSpacing_m = 2.0;
  const double area_m2 =
      2.0 * options.fit_half_width_m * (footprint.length_m + 2.0 * options.fit_half_width_m);
  const double spacing_m = std::min(kMaxSpacing_m, point_spacing_m(zone.size(), area_m2));
  const ZoneCells cells(zone, std::max(kMinCellSize_m, 1.5 * spacing_m));

  std::vector<CandidatePlane> candidates;
  const auto add = [&](const std::vector<FoundPlane>& planes) {
    for (const FoundPlane& found : planes) {
      if (is_strip(found) || lets_laser_through(found, zone, options)) continue;
      unite(extend(found, cells, options), candidates);
    }
  };
  add(planes_beside(zone, footprint, options, normals));
  add(search_planes(unexplained(zone, candidates, footprint, options), options, normals));
  drop_shadows(candidates, options);
  for (CandidatePlane& plane : candidates) describe_support(plane, footprint, spacing_m, options);
  if (auto ledge = search_ledge(zone, candidates, footprint, options)) {
    describe_support(*ledge, footprint, 2.0 * spacing_m, options);  // a strip has sparse points
    candidates.push_back(std::move(*ledge));
  }
  return candidates;
}

}  // namespace ridgeline::evaluate
