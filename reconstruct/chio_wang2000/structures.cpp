// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/chio_wang2000/structures.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/segment_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

/// Two segments that meet.
struct Crossing {
  Eigen::Vector2d x;
  int first = 0, second = 0;
  double gap_px = 0.0;  ///< sum of their distances from x
};

double end_distance(const Segment2& s, const Eigen::Vector2d& x) {
  return std::min((s.start - x).norm(), (s.end - x).norm());
}

std::vector<Crossing> crossings_of(std::span<const Segment2> segments, const ChioOptions& options) {
  const SegmentIndex index(segments);
  const double radius = options.junction_radius_px;
  std::set<std::pair<int, int>> seen;
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (const Eigen::Vector2d& end : {segments[i].start, segments[i].end}) {
      for (const int k : index.near({end, end}, 2.0 * radius)) {
        const int id = static_cast<int>(i);
        if (k == id) continue;
        const auto x =
            intersection(segments[i], segments[k], options.min_junction_angle_deg * kRadPerDeg);
        if (!x || end_distance(segments[i], *x) > radius) continue;
        const double gap_px = end_distance(segments[i], *x) + distance(segments[k], *x);
        if (distance(segments[k], *x) > radius) continue;
        if (!seen.insert(std::minmax(id, k)).second) continue;
        crossings.push_back({*x, std::min(id, k), std::max(id, k), gap_px});
      }
    }
  }
  std::stable_sort(crossings.begin(), crossings.end(),
                   [](const Crossing& a, const Crossing& b) { return a.gap_px < b.gap_px; });
  return crossings;
}

/// Crossings grouped around the most precise ones: by group the first and all its crossings.
std::vector<std::vector<Crossing>> grouped(const std::vector<Crossing>& crossings, double radius) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> groups_in_cell;
  const auto cell_of = [&](const Eigen::Vector2d& x) {
    return std::pair(static_cast<int>(std::floor(x.x() / radius)),
                     static_cast<int>(std::floor(x.y() / radius)));
  };
  std::vector<std::vector<Crossing>> groups;
  for (const Crossing& crossing : crossings) {
    const auto [column, row] = cell_of(crossing.x);
    std::size_t nearest = groups.size();
    double nearest_px = radius;
    for (int cell = 0; cell < 9; ++cell) {
      const auto found = groups_in_cell.find({column + cell % 3 - 1, row + cell / 3 - 1});
      if (found == groups_in_cell.end()) continue;
      for (const std::size_t g : found->second) {
        const double apart_px = (groups[g].front().x - crossing.x).norm();
        if (apart_px > nearest_px) continue;
        nearest = g;
        nearest_px = apart_px;
      }
    }
    if (nearest == groups.size()) {
      groups_in_cell[{column, row}].push_back(groups.size());
      groups.emplace_back();
    }
    groups[nearest].push_back(crossing);
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

std::vector<Structure> linear_structures(std::span<const Segment2> segments,
                                         const ChioOptions& options) {
  std::vector<Structure> structures;
  for (const std::vector<Crossing>& group :
       grouped(crossings_of(segments, options), options.junction_radius_px)) {
    structures.push_back(structure_of(group, segments));
  }
  const auto rank = [](const Structure& s) {
    return std::tuple(-static_cast<int>(s.members.size()), -s.length_px, s.precision_px);
  };
  std::stable_sort(structures.begin(), structures.end(),
                   [&](const Structure& a, const Structure& b) { return rank(a) < rank(b); });
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
