// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/structures.h"

#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/degrees.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

namespace bg = boost::geometry;

// Ours; the paper gives neither.
constexpr double kJunctionRadius_px = 5.0;  // largest distance of a junction from its segments
constexpr double kMinJunctionAngle_rad = 20.0 * kRadPerDeg;

/// Two segments that meet.
struct Crossing {
  Eigen::Vector2d x;
  int first = 0, second = 0;
  /// Distance of an end of one segment from x, plus that of the other segment.
  double gap_px = 0.0;
};

double end_distance(const Segment2& s, const Eigen::Vector2d& x) {
  return std::min((s.start - x).norm(), (s.end - x).norm());
}

std::vector<Crossing> crossings_of(std::span<const Segment2> segments) {
  const BoxIndex2 index(segments);
  std::set<std::pair<std::size_t, std::size_t>> seen;
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (const Eigen::Vector2d& end : {segments[i].start, segments[i].end}) {
      for (const std::size_t k : index.near(Segment2{end, end}, 2.0 * kJunctionRadius_px)) {
        if (k == i) continue;
        const auto x = intersection(segments[i], segments[k], kMinJunctionAngle_rad);
        if (!x || end_distance(segments[i], *x) > kJunctionRadius_px) continue;
        const double gap_px = end_distance(segments[i], *x) + distance(segments[k], *x);
        if (distance(segments[k], *x) > kJunctionRadius_px) continue;
        if (!seen.insert(std::minmax(i, k)).second) continue;
        crossings.push_back(
            {*x, static_cast<int>(std::min(i, k)), static_cast<int>(std::max(i, k)), gap_px});
      }
    }
  }
  std::ranges::stable_sort(crossings, {}, &Crossing::gap_px);
  return crossings;
}

/// Groups of crossings. Each group begins with its most precise crossing; the others lie within the
/// radius around it.
std::vector<std::vector<Crossing>> grouped(const std::vector<Crossing>& crossings, double radius) {
  using Place = bg::model::d2::point_xy<double>;
  bg::index::rtree<std::pair<Place, std::size_t>, bg::index::quadratic<16>> first_of_groups;
  std::vector<std::vector<Crossing>> groups;
  for (const Crossing& crossing : crossings) {
    const Place place(crossing.x.x(), crossing.x.y());
    const auto nearest = first_of_groups.qbegin(bg::index::nearest(place, 1));
    if (nearest != first_of_groups.qend() && bg::distance(nearest->first, place) <= radius) {
      groups[nearest->second].push_back(crossing);
      continue;
    }
    first_of_groups.insert({place, groups.size()});
    groups.push_back({crossing});
  }
  return groups;
}

Structure structure_of(const std::vector<Crossing>& crossings, std::span<const Segment2> segments) {
  Structure structure;
  structure.junction_px = crossings.front().x;
  std::set<int> members;
  for (const Crossing& crossing : crossings) members.insert({crossing.first, crossing.second});
  structure.members.assign(members.begin(), members.end());
  for (const int m : structure.members) {
    structure.length_px += length(segments[m]);
    structure.precision_px += distance(segments[m], structure.junction_px) /
                              static_cast<double>(structure.members.size());
  }
  return structure;
}

}  // namespace

std::vector<Structure> linear_structures(std::span<const Segment2> segments) {
  std::vector<Structure> structures;
  for (const std::vector<Crossing>& group : grouped(crossings_of(segments), kJunctionRadius_px)) {
    structures.push_back(structure_of(group, segments));
  }
  std::ranges::stable_sort(structures, {}, [](const Structure& s) {
    return std::tuple(-static_cast<int>(s.members.size()), -s.length_px, s.precision_px);
  });
  return structures;
}

std::vector<std::vector<int>> structures_of_segments(std::span<const Structure> structures,
                                                     std::size_t n_segments) {
  std::vector<std::vector<int>> of_segment(n_segments);
  for (std::size_t s = 0; s < structures.size(); ++s) {
    for (const int m : structures[s].members) of_segment[m].push_back(static_cast<int>(s));
  }
  return of_segment;
}

}  // namespace ridgeline::reconstruct
