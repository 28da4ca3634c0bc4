// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/simulate_arguments.h"
#include "evaluate/files/output_folder.h"
#include "io/lines/line_set.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The frames of a block. Throws std::invalid_argument if any place of its area is shown by fewer
/// than two of them.
std::vector<simulate::AerialView> block_frames(const simulate::SyntheticScene& scene,
                                               const SimulateArguments& arguments);

/// Names of the files that write_block() writes.
std::vector<std::string> block_file_names(const simulate::SyntheticScene& scene,
                                          std::span<const simulate::AerialView> frames,
                                          const SimulateArguments& arguments);

/// Writes a block: the LIDAR tiles, the orientation, the frames, which show the village with
/// fittings, and block.yaml, which refers to these and truth.geojson. Only one tile or some rows of
/// a frame are in memory at a time. Returns the number of laser points.
std::size_t write_block(const simulate::SyntheticScene& bare_scene,
                        std::span<const simulate::AerialView> frames,
                        const std::string& block_id,
                        const SimulateArguments& arguments,
                        const results::OutputFolder& out);

}  // namespace ridgeline::apps
