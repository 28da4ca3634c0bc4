// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/cloud_readings.h"
#include "evaluate/scan/find_edges.h"
#include "io/cloud/cloud_files.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace ridgeline::results {

struct EdgesOfCloud {
  evaluate::ScanEdges edges;  ///< in the frame of the cloud
  CloudReadings readings;
};

/// Called after each cell of the map with the numbers of cells that are done and that are known so
/// far; never by two threads at once.
using CellProgress = std::function<void(std::size_t n_done, std::size_t n_total)>;

/// The planes and edges of a cloud of any size. They are found in cells of 100 m of the map, each
/// with the points up to 30 m outside it, and what two cells find is merged. Coordinates are
/// rounded to 2^-14 m of the world. The result therefore depends neither on how the cloud is
/// divided into files nor on the order of the points, repeated points, the memory or the number of
/// threads; in world coordinates it does not depend on the frame either.
///
/// If the points need more memory than `max_memory_bytes`, the cloud is read in rectangles of whole
/// cells, which are halved until their points fit. The points of a single cell are read even if
/// they exceed the limit, with a warning. `area_in_world_m`: only the edges whose middle lies there
/// (its upper sides do not belong to it) and the planes that they bound or whose centroid lies
/// there; points farther than 300 m from it are not used. `progress` may be empty. Throws IoError
/// under the same conditions as read_cloud().
EdgesOfCloud edges_of_cloud(io::CloudFiles& cloud,
                            const std::optional<Eigen::AlignedBox2d>& area_in_world_m,
                            std::uint64_t max_memory_bytes,
                            const CellProgress& progress = {},
                            const evaluate::ScanOptions& options = {});

/// Whether the options keep only the class of buildings (6), so that the cloud has no ground: see
/// ScanOptions::only_roofs.
bool keeps_only_buildings(const io::ReadOptions& options);

/// Throws IoError if no point was read.
void require_points(const CloudReadings& readings, const io::CloudFiles& cloud);

}  // namespace ridgeline::results
