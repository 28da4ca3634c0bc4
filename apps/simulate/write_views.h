// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"
#include "apps/simulate/view_files.h"
#include "evaluate/files/output_folder.h"
#include "io/lines/line_set.h"

#include <string>
#include <vector>

namespace ridgeline::apps {

/// Names of the files that write_views() writes.
std::vector<std::string> view_file_names(const ViewOptions& options);

/// Renders all views of a scene, with its fittings, and writes an image ID.tif of each, matches.csv
/// (the true matches of the first two), for three or more views tracks.csv (the true tracks), the
/// orientation if a format is set, and patch.yaml, which also refers to lidar.las and truth.geojson
/// and, for whole frames, states the area of the village. Returns `truth`, the true lines in order
/// of SyntheticScene::lines, with their class for these cameras, their visible shares in the first
/// two views and, for three or more views, the number of views that see at least half of the line.
io::LineSet write_views(const simulate::SyntheticScene& bare_scene,
                        const std::string& patch_id,
                        const ViewOptions& options,
                        io::LineSet truth,
                        const results::OutputFolder& out);

}  // namespace ridgeline::apps
