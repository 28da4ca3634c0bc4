// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/flight.h"
#include "apps/simulate/shown_edge.h"

#include <span>
#include <string>
#include <vector>

namespace ridgeline::simulate {

/// The true tracks: the edges that are clearly visible in at least two views, with their clear runs
/// and without duplicates. Their contrast must have been measured.
std::vector<ShownEdge> edge_tracks(std::span<const ShownEdge> edges);

/// The text of tracks.csv: edge,kind,image,x1_px,y1_px,x2_px,y2_px,visible, one row for each
/// run. Edges are numbered from 1.
std::string tracks_csv(std::span<const ShownEdge> tracks, std::span<const AerialView> views);

}  // namespace ridgeline::simulate
