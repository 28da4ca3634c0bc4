// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/alpha_shape.h"

#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

namespace ridgeline::evaluate {
namespace {

using boost::polygon::voronoi_diagram;

constexpr double kUnitsPerMetre = 10000.0;

struct DelaunayTriangle {
  std::array<std::size_t, 3> corners;  ///< counter-clockwise
  double circumradius_m;
};

std::vector<DelaunayTriangle> delaunay(std::span<const Eigen::Vector2d> points_m) {
  std::vector<boost::polygon::point_data<std::int32_t>> sites;
  sites.reserve(points_m.size());
  const Eigen::Vector2d origin = points_m[0];
  for (const Eigen::Vector2d& x : points_m) {
    const Eigen::Vector2d units = (x - origin) * kUnitsPerMetre;
    sites.emplace_back(static_cast<std::int32_t>(std::lround(units.x())),
                       static_cast<std::int32_t>(std::lround(units.y())));
  }
  voronoi_diagram<double> diagram;
  boost::polygon::construct_voronoi(sites.begin(), sites.end(), &diagram);
  std::vector<DelaunayTriangle> triangles;
  triangles.reserve(2 * points_m.size());
  for (const auto& vertex : diagram.vertices()) {
    const Eigen::Vector2d centre =
        Eigen::Vector2d(vertex.x(), vertex.y()) / kUnitsPerMetre + origin;
    // sites on one circle have one vertex: a fan of triangles
    std::vector<std::size_t> around;
    const auto* edge = vertex.incident_edge();
    do {
      around.push_back(edge->cell()->source_index());
      edge = edge->rot_next();
    } while (edge != vertex.incident_edge());
    const double radius_m = (points_m[around[0]] - centre).norm();
    for (std::size_t i = 1; i + 1 < around.size(); ++i)
      triangles.push_back({{around[0], around[i], around[i + 1]}, radius_m});
  }
  return triangles;
}

double area_m2(const DelaunayTriangle& t, std::span<const Eigen::Vector2d> x) {
  const Eigen::Vector2d a = x[t.corners[1]] - x[t.corners[0]],
                        b = x[t.corners[2]] - x[t.corners[0]];
  return 0.5 * (a.x() * b.y() - a.y() * b.x());
}

/// The largest circumradius that is still covered. For random points of density r, r pi R^2 has the
/// distribution 1 - (1 + x) exp(-x) with the median 1.678; of 10,000 triangles about four are
/// larger than 1.8 / sqrt(r).
double largest_radius_m(std::span<const DelaunayTriangle> triangles) {
  constexpr double kMedian = 1.678, kSpacings = 1.8;
  std::vector<double> radii;
  for (const DelaunayTriangle& t : triangles) radii.push_back(t.circumradius_m);
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::ranges::nth_element(radii, middle);
  return kSpacings * *middle * std::sqrt(std::numbers::pi / kMedian);
}

/// Directed edges that only one triangle has, chained.
std::vector<std::vector<std::size_t>> loops_of(const std::vector<DelaunayTriangle>& triangles) {
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  for (const DelaunayTriangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair side(t.corners[i], t.corners[(i + 1) % 3]);
      const auto opposite = sides.find({side.second, side.first});
      if (opposite != sides.end()) {
        sides.erase(opposite);
      } else {
        sides.emplace(side, 0);
      }
    }
  }
  std::vector<std::vector<std::size_t>> loops;
  while (!sides.empty()) {
    std::vector<std::size_t>& loop = loops.emplace_back();
    auto side = sides.begin();
    while (side != sides.end()) {
      loop.push_back(side->first.first);
      const std::size_t to = side->first.second;
      sides.erase(side);
      side = sides.lower_bound({to, 0});
      if (side != sides.end() && side->first.first != to) side = sides.end();
    }
  }
  return loops;
}

}  // namespace

AlphaShape alpha_shape(std::span<const Eigen::Vector2d> points_m) {
  AlphaShape shape;
  if (points_m.size() < 3) return shape;
  std::vector<DelaunayTriangle> triangles = delaunay(points_m);
  std::erase_if(triangles,
                [&](const DelaunayTriangle& t) { return !(area_m2(t, points_m) > 0.0); });
  if (triangles.empty()) return shape;
  const double limit_m = largest_radius_m(triangles);
  std::erase_if(triangles, [&](const DelaunayTriangle& t) { return t.circumradius_m > limit_m; });
  for (const DelaunayTriangle& t : triangles) shape.area_m2 += area_m2(t, points_m);
  shape.loops = loops_of(triangles);
  return shape;
}

}  // namespace ridgeline::evaluate
