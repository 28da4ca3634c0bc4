// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/point_distances.h"

#include "evaluate/faces/face_points.h"
#include "evaluate/faces/overhang.h"
#include "evaluate/statistics/distribution.h"
#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/interruption.h"
#include "reconstruct/geometry/transformed.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace ridgeline::evaluate {
namespace {

constexpr double kBeside_m = 0.5;
constexpr double kGround_m = 0.5;
constexpr double kFarBelow_m = 1.5;
// ASPRS
constexpr std::uint8_t kUnclassified = 1, kGroundClass = 2;

/// A planar face in space, which may be vertical.
class FaceSurface {
 public:
  explicit FaceSurface(const RoofFace& face)
      : plane_(face.plane), origin_(face.rings.front().front()) {
    axes_.col(0) = plane_.normal().unitOrthogonal();
    axes_.col(1) = plane_.normal().cross(axes_.col(0));
    std::vector<std::vector<Eigen::Vector3d>> rings = face.rings;
    for (auto& ring : rings)
      for (Eigen::Vector3d& x : ring) x << in_plane(x), 0.0;
    polygon_ = PlanPolygon(rings);
  }

  /// Distance of a point from the surface, or `at_most_m` if it is larger.
  [[nodiscard]] double distance_m(const Eigen::Vector3d& x, double at_most_m) const {
    const double off_m = plane_.absDistance(x);
    if (off_m >= at_most_m) return at_most_m;
    return std::min(at_most_m, std::hypot(off_m, polygon_.distance_m(in_plane(x))));
  }

 private:
  [[nodiscard]] Eigen::Vector2d in_plane(const Eigen::Vector3d& x) const {
    return axes_.transpose() * (x - origin_);
  }

  Plane3 plane_;
  Eigen::Vector3d origin_;
  Eigen::Matrix<double, 3, 2> axes_;
  PlanPolygon polygon_;
};

struct ClassedPoint {
  Eigen::Vector3d x;
  std::uint8_t of_class;
};

bool is_noise_or_plant_or_water(std::uint8_t of_class) {
  switch (of_class) {
    case 3:  // low, medium and high vegetation
    case 4:
    case 5:
    case 7:  // low and high noise
    case 9:  // water
    case 18:
      return true;
    default:
      return false;
  }
}

/// The surfaces with which the points of one building are compared.
class BuildingSurfaces {
 public:
  explicit BuildingSurfaces(const RoofBuilding& building) {
    for (const RoofFace& face : building.faces) {
      if (face.degenerate) continue;
      roofs_.push_back(&face);
      add(face);
    }
    for (const RoofFace& face : building.others)
      if (!face.degenerate) add(face);
  }

  [[nodiscard]] double lowest_m() const { return lowest_m_; }
  [[nodiscard]] Eigen::AlignedBox2d box() const {
    Eigen::AlignedBox2d box;
    for (const RoofFace* roof : roofs_) box.extend(roof->plan.box());
    return box;
  }

  [[nodiscard]] bool is_over_or_beside(const Eigen::Vector2d& x) const {
    return std::ranges::any_of(roofs_, [&](const RoofFace* roof) {
      return roof->plan.box().squaredExteriorDistance(x) <= kBeside_m * kBeside_m &&
             roof->plan.distance_m(x) <= kBeside_m;
    });
  }

  /// Distance of a point from the nearest surface, or `nearest_m` if it is larger.
  [[nodiscard]] double to_surface_m(const Eigen::Vector3d& x, double nearest_m) const {
    for (const FaceSurface& surface : surfaces_) nearest_m = surface.distance_m(x, nearest_m);
    return nearest_m;
  }

  /// How far a point lies below the part of the roof closest to it in height, negative above it;
  /// empty beside the roof.
  [[nodiscard]] std::optional<double> below_roof_m(const Eigen::Vector3d& x) const {
    std::optional<double> nearest_m;
    for (const RoofFace* roof : roofs_) {
      if (is_upright(*roof) || !roof->plan.contains(x.head<2>())) continue;
      const double below_m = height_at(roof->plane, x.head<2>()) - x.z();
      if (!nearest_m || std::abs(below_m) < std::abs(*nearest_m)) nearest_m = below_m;
    }
    return nearest_m;
  }

  [[nodiscard]] bool is_under_roof(const Eigen::Vector2d& x) const {
    return std::ranges::any_of(roofs_,
                               [&](const RoofFace* roof) { return roof->plan.contains(x); });
  }

 private:
  void add(const RoofFace& face) {
    surfaces_.emplace_back(face);
    for (const auto& ring : face.rings)
      for (const Eigen::Vector3d& x : ring) lowest_m_ = std::min(lowest_m_, x.z());
  }

  std::vector<const RoofFace*> roofs_;  // those that are not degenerate
  std::vector<FaceSurface> surfaces_;   // roofs first
  double lowest_m_ = std::numeric_limits<double>::infinity();
};

/// Sorted by position, regardless of the order of the cloud.
std::vector<ClassedPoint> points_of(const PointSearch& search,
                                    const BuildingSurfaces& building,
                                    std::span<const std::uint8_t> classes) {
  std::vector<ClassedPoint> points;
  const Corridor corridor = corridor_of(building.box());
  search.visit_near(
      corridor.axis, corridor.half_width_m + kBeside_m, [&](const PointSearch::Point& p) {
        if (!building.is_over_or_beside(p.x.head<2>())) return;
        points.push_back({p.x, p.index < classes.size() ? classes[p.index] : std::uint8_t{0}});
      });
  const auto place = [](const ClassedPoint& p) { return std::tuple(p.x.x(), p.x.y(), p.x.z()); };
  std::ranges::sort(points, {},
                    [&](const ClassedPoint& p) { return std::tuple(place(p), p.of_class); });
  const auto same = [&](const ClassedPoint& a, const ClassedPoint& b) {
    return place(a) == place(b);
  };
  points.erase(std::unique(points.begin(), points.end(), same), points.end());
  return points;
}

double nearest_m(const Eigen::Vector3d& x, std::span<const BuildingSurfaces* const> buildings) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const BuildingSurfaces* building : buildings)
    nearest_m = building->to_surface_m(x, nearest_m);
  return nearest_m;
}

/// Whether a ray that passes the roofs may have hit a point this far below one.
bool is_seen_past_roofs(const Eigen::Vector3d& x,
                        double below_m,
                        std::span<const BuildingSurfaces* const> buildings) {
  return below_m > kBeside_m && is_under_overhang(x.head<2>(), below_m, [&](const auto& place) {
           return std::ranges::any_of(
               buildings, [&](const auto* building) { return building->is_under_roof(place); });
         });
}

/// The median of distances that agree with each other; empty if they do not.
std::optional<double> common_distance_m(const std::vector<double>& distances_m) {
  constexpr double kAgree_m = 0.15;
  if (distances_m.empty()) return std::nullopt;
  const double spread_m = *quantile(distances_m, 0.84) - *quantile(distances_m, 0.16);
  return spread_m <= 2.0 * kAgree_m ? quantile(distances_m, 0.5) : std::nullopt;
}

/// @param around  the building and those that it adjoins
PointDistances distances_of(const std::vector<ClassedPoint>& points,
                            const BuildingSurfaces& building,
                            std::span<const BuildingSurfaces* const> around) {
  PointDistances distances;
  std::vector<double> below_roof_m, z_over_m, z_beside_m;
  for (const ClassedPoint& p : points) {
    if (is_noise_or_plant_or_water(p.of_class)) continue;
    const bool is_low = p.x.z() < building.lowest_m() + kGround_m;
    const bool is_ground = p.of_class == kGroundClass || (p.of_class <= kUnclassified && is_low);
    const std::optional<double> below_m = building.below_roof_m(p.x);
    if (below_m || !is_ground) distances.to_surface_m.push_back(nearest_m(p.x, around));
    (below_m ? z_over_m : z_beside_m).push_back(p.x.z());
    if (!below_m) continue;
    below_roof_m.push_back(*below_m);
    ++distances.n_over;
    distances.over_squares_m2 += *below_m * *below_m;
    if (*below_m > kFarBelow_m) ++distances.n_far_below;
    if (is_ground || is_seen_past_roofs(p.x, *below_m, around)) continue;
    distances.to_roof_m.push_back(std::abs(*below_m));
  }
  distances.parallel_below_m = common_distance_m(below_roof_m);
  // On a slope, this quantile is near the middle; higher points may belong to walls and bushes.
  constexpr double kLow = 0.3;
  if (!z_over_m.empty() && !z_beside_m.empty())
    distances.above_ground_m =
        *quantile(std::move(z_over_m), 0.5) - *quantile(std::move(z_beside_m), kLow);
  return distances;
}

}  // namespace

std::vector<PointDistances> point_distances(const PointSearch& search,
                                            std::span<const RoofBuilding> buildings,
                                            std::span<const std::uint8_t> classes) {
  std::vector<BuildingSurfaces> surfaces;
  for (const RoofBuilding& building : buildings) surfaces.emplace_back(building);
  const BoxIndex2 index(transformed(surfaces, [](const auto& building) { return building.box(); }));
  std::vector<PointDistances> distances(buildings.size());
  tbb::parallel_for(std::size_t{0}, buildings.size(), [&](std::size_t i) {
    Interruption::check();
    if (surfaces[i].box().isEmpty()) return;
    std::vector<const BuildingSurfaces*> around{&surfaces[i]};
    for (const std::size_t other : index.near(surfaces[i].box(), kBeside_m))
      if (other != i) around.push_back(&surfaces[other]);
    distances[i] = distances_of(points_of(search, surfaces[i], classes), surfaces[i], around);
  });
  return distances;
}

}  // namespace ridgeline::evaluate
