// SPDX-License-Identifier: BSD-3-Clause
#include "tests/acceptance/roof_ridges.h"

#include "reconstruct/geometry/plane.h"
#include "tests/support/random.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace ridgeline::test {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double kCell_m = 1.0;
constexpr double kInlierDistance_m = 0.08;  // 3 sigma of the tiles' roofs: rms 2 to 4 cm
constexpr std::size_t kMinPlanePoints = 120;
constexpr int kMinBeside = 8;  // per metre of a line, beside it
constexpr double kMaxSlope_rad = 60.0 * std::numbers::pi / 180.0;

struct RoofPlane {
  Plane3 plane{Eigen::Vector3d::UnitZ(), 0.0};
  Points inliers;
};

using Cell = std::pair<int, int>;

Cell cell_of(const Eigen::Vector3d& x) {
  return {static_cast<int>(std::floor(x.x() / kCell_m)),
          static_cast<int>(std::floor(x.y() / kCell_m))};
}

/// Takes the cell and all that are connected to it out of the grid.
Points take_building(std::map<Cell, Points>& cells) {
  Points building;
  std::vector<Cell> open{cells.begin()->first};
  while (!open.empty()) {
    const auto [column, row] = open.back();
    open.pop_back();
    const auto found = cells.find({column, row});
    if (found == cells.end()) continue;
    building.insert(building.end(), found->second.begin(), found->second.end());
    cells.erase(found);
    for (int dc = -1; dc <= 1; ++dc) {
      for (int dr = -1; dr <= 1; ++dr) open.emplace_back(column + dc, row + dr);
    }
  }
  return building;
}

/// Splits off the points near the plane: (near, far).
std::pair<Points, Points> split(const Points& points, const Plane3& plane) {
  std::pair<Points, Points> parts;
  for (const Eigen::Vector3d& x : points) {
    (plane.absDistance(x) <= kInlierDistance_m ? parts.first : parts.second).push_back(x);
  }
  return parts;
}

Plane3 least_squares_plane(const Points& points) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& x : points) centre += x / static_cast<double>(points.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& x : points) scatter += (x - centre) * (x - centre).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  const Eigen::Vector3d normal = solver.eigenvectors().col(0);
  return upward(Plane3(normal, centre));
}

/// The plane through three random points that has the most points near it.
std::optional<Plane3> consensus_plane(const Points& points, Random& random) {
  constexpr int kTrials = 2000;
  const auto pick = [&] { return points[static_cast<std::size_t>(random.bits() % points.size())]; };
  std::optional<Plane3> best;
  std::size_t most = kMinPlanePoints;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::Vector3d a = pick();
    const Eigen::Vector3d ab = pick() - a;
    const Eigen::Vector3d normal = ab.cross(pick() - a);
    if (normal.norm() < 1.0) continue;  // points too close together
    const Plane3 plane(normal.normalized(), a);
    if (slope_rad(plane) > kMaxSlope_rad) continue;
    const std::size_t count = split(points, plane).first.size();
    if (count > most) {
      most = count;
      best = plane;
    }
  }
  return best;
}

std::vector<RoofPlane> planes_of(Points building, Random& random) {
  std::vector<RoofPlane> planes;
  while (building.size() >= kMinPlanePoints) {
    const std::optional<Plane3> consensus = consensus_plane(building, random);
    if (!consensus) break;
    const Plane3 fitted = least_squares_plane(split(building, *consensus).first);
    auto [inliers, rest] = split(building, fitted);
    if (inliers.size() < kMinPlanePoints) break;
    planes.push_back({least_squares_plane(inliers), std::move(inliers)});
    building = std::move(rest);
  }
  return planes;
}

struct Line3 {
  Eigen::Vector3d origin, direction;
};

std::optional<Line3> intersection(const Plane3& a, const Plane3& b) {
  constexpr double kMinAngle_rad = 10.0 * std::numbers::pi / 180.0;
  const Eigen::Vector3d along = a.normal().cross(b.normal());
  if (std::asin(std::min(1.0, along.norm())) < kMinAngle_rad) return std::nullopt;
  Eigen::Matrix3d normals;
  normals << a.normal().transpose(), b.normal().transpose(), along.transpose();
  const Eigen::Vector3d offsets(-a.offset(), -b.offset(), 0.0);
  return Line3{normals.inverse() * offsets, along.normalized()};
}

/// The metres along the line (floor of t) beside which the plane has a few points.
std::map<int, int> beside(const Line3& line, const Points& points) {
  constexpr double kReach_m = 1.2;
  // nearer points are close to both planes, whichever of them took the points
  constexpr double kStraddling_m = 0.3;
  std::map<int, int> counts;
  for (const Eigen::Vector3d& x : points) {
    const Eigen::Vector3d from_origin = x - line.origin;
    const double t = from_origin.dot(line.direction);
    const double distance_m = (from_origin - t * line.direction).norm();
    if (distance_m < kStraddling_m || distance_m > kReach_m) continue;
    ++counts[static_cast<int>(std::floor(t))];
  }
  std::erase_if(counts, [](const auto& count) { return count.second < kMinBeside; });
  return counts;
}

/// The longest stretch with points of both planes.
std::optional<Segment3> ridge(const RoofPlane& a, const RoofPlane& b) {
  constexpr int kMinLength_m = 3;
  const std::optional<Line3> line = intersection(a.plane, b.plane);
  if (!line) return std::nullopt;
  const std::map<int, int> beside_b = beside(*line, b.inliers);
  int begin = 0, end = 0, best_begin = 0, best_end = 0;
  for (const auto& [t, count] : beside(*line, a.inliers)) {
    if (!beside_b.contains(t)) continue;
    if (t != end) begin = t;
    end = t + 1;
    if (end - begin > best_end - best_begin) {
      best_begin = begin;
      best_end = end;
    }
  }
  if (best_end - best_begin < kMinLength_m) return std::nullopt;
  return Segment3{line->origin + best_begin * line->direction,
                  line->origin + best_end * line->direction};
}

}  // namespace

std::vector<Segment3> roof_ridges(const Points& points) {
  std::map<Cell, Points> cells;
  for (const Eigen::Vector3d& x : points) cells[cell_of(x)].push_back(x);
  Random random(1);
  std::vector<Segment3> ridges;
  while (!cells.empty()) {
    const std::vector<RoofPlane> planes = planes_of(take_building(cells), random);
    for (std::size_t i = 0; i < planes.size(); ++i) {
      for (std::size_t j = i + 1; j < planes.size(); ++j) {
        if (const auto found = ridge(planes[i], planes[j])) ridges.push_back(*found);
      }
    }
  }
  return ridges;
}

}  // namespace ridgeline::test
