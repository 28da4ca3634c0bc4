// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/straight_vertices.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ridgeline::io {
namespace {

/// Squared distance to the segment, not to its infinite line, so that a polyline that turns back on
/// itself has a bend there.
double squared_distance(const Eigen::Vector3d& x,
                        const Eigen::Vector3d& start,
                        const Eigen::Vector3d& end) {
  const Eigen::Vector3d along = end - start;
  const double squared_length = along.squaredNorm();
  const double t =
      squared_length > 0.0 ? std::clamp((x - start).dot(along) / squared_length, 0.0, 1.0) : 0.0;
  return (x - start - t * along).squaredNorm();
}

/// Marks the bends between the vertices `first` and `last`, which are themselves bends. Vertices
/// arranged so that every range splits at its end would take forever. So after far more work than
/// any drawn line takes, all other vertices are treated as bends.
void mark_bends(const Vertices& vertices,
                std::size_t first,
                std::size_t last,
                std::vector<char>& is_bend) {
  constexpr std::size_t kPerVertex = 200;
  std::size_t work_left = 10'000'000 + kPerVertex * (last - first);
  std::vector<std::pair<std::size_t, std::size_t>> ranges{{first, last}};
  while (!ranges.empty()) {
    const auto [begin, end] = ranges.back();
    ranges.pop_back();
    if (end - begin > work_left) {
      std::fill(is_bend.begin() + static_cast<std::ptrdiff_t>(begin),
                is_bend.begin() + static_cast<std::ptrdiff_t>(end), 1);
      continue;
    }
    work_left -= end - begin;
    double largest = kStraightTolerance * kStraightTolerance;
    std::size_t farthest = begin;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const double d = squared_distance(vertices[i], vertices[begin], vertices[end]);
      if (d > largest) {
        largest = d;
        farthest = i;
      }
    }
    if (farthest == begin) continue;
    is_bend[farthest] = 1;
    ranges.emplace_back(begin, farthest);
    ranges.emplace_back(farthest, end);
  }
}

std::size_t farthest_from(const Vertices& vertices, const Eigen::Vector3d& x) {
  std::size_t farthest = 0;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    if ((vertices[i] - x).squaredNorm() > (vertices[farthest] - x).squaredNorm()) farthest = i;
  }
  return farthest;
}

bool is_closed(const Vertices& vertices) {
  return vertices.size() > 3 && vertices.front() == vertices.back();
}

/// The bends of a closed ring. The vertex farthest from any given vertex is a corner of the ring's
/// convex hull, so the ring bends there.
Vertices bends_of_ring(const Vertices& closed) {
  const Vertices ring(closed.begin(), closed.end() - 1);
  const std::size_t corner = farthest_from(ring, ring.front());
  Vertices turned(ring);
  std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(corner), turned.end());
  turned.push_back(turned.front());
  const std::size_t opposite = farthest_from(turned, turned.front());
  std::vector<char> is_bend(turned.size(), 0);
  is_bend.front() = is_bend[opposite] = 1;
  mark_bends(turned, 0, opposite, is_bend);
  mark_bends(turned, opposite, turned.size() - 1, is_bend);
  Vertices bends;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t in_turned = (i + ring.size() - corner) % ring.size();
    if (is_bend[in_turned] != 0) bends.push_back(ring[i]);
  }
  bends.push_back(bends.front());
  return bends;
}

}  // namespace

Vertices bends_of(const Vertices& vertices) {
  const bool finite = std::ranges::all_of(vertices, [](const auto& x) { return x.allFinite(); });
  if (vertices.size() < 3 || !finite) return vertices;
  if (is_closed(vertices)) return bends_of_ring(vertices);
  std::vector<char> is_bend(vertices.size(), 0);
  is_bend.front() = is_bend.back() = 1;
  mark_bends(vertices, 0, vertices.size() - 1, is_bend);
  Vertices bends;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (is_bend[i] != 0) bends.push_back(vertices[i]);
  }
  return bends;
}

}  // namespace ridgeline::io
