// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/scan_cells.h"

#include "evaluate/scan/find_edges.h"

#include <utility>

namespace ridgeline::results {

EdgesOfCloud edges_of_cloud(io::CloudFiles& cloud,
                            const std::optional<Eigen::AlignedBox2d>& /*area_in_world_m*/,
                            std::uint64_t /*max_memory_bytes*/,
                            const CellProgress& /*progress*/) {
  io::PointCloud points = cloud.read({});
  std::vector<Eigen::Vector3d> positions;
  for (const io::CloudPoint& p : points.points) positions.emplace_back(p.x, p.y, p.z);
  EdgesOfCloud found{.edges = evaluate::find_edges(positions), .readings = {}};
  add_reading(std::move(points), positions.size(), found.readings);
  return found;
}

}  // namespace ridgeline::results
