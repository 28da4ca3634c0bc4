// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/mesh_edges.h"

#include <array>
#include <set>
#include <utility>

namespace ridgeline::io {
namespace {

using Coordinates = std::array<double, 3>;

Coordinates coordinates_of(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

}  // namespace

void append_distinct_edges(const Vertices& vertices,
                           const std::vector<IndexList>& polygons,
                           LineSet& set) {
  std::set<std::pair<Coordinates, Coordinates>> known;
  std::size_t number = 0;
  for (const IndexList& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Eigen::Vector3d& start = vertices[polygon[i]];
      const Eigen::Vector3d& end = vertices[polygon[(i + 1) % polygon.size()]];
      // A NaN has no place in an order: such an edge is kept, whatever came before.
      const bool finite = start.allFinite() && end.allFinite();
      if (finite && start == end) continue;
      std::pair edge(coordinates_of(start), coordinates_of(end));
      if (edge.second < edge.first) std::swap(edge.first, edge.second);
      if (finite && !known.insert(edge).second) continue;
      append_segment({}, {start, end}, number++, set);
    }
  }
}

}  // namespace ridgeline::io
