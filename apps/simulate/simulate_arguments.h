// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/als.h"
#include "apps/simulate/block_flight.h"
#include "apps/simulate/view_files.h"
#include "apps/simulate/village.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The options of `ridgeline simulate`.
struct SimulateArguments {
  std::string out;
  std::uint64_t seed = 1;
  std::vector<double> extent_m{120.0, 120.0};
  std::vector<double> origin_m{513000.0, 5403000.0, 250.0};
  simulate::VillageOptions village;
  simulate::AlsOptions als;
  ViewOptions views;
  std::vector<int> frame_px;  ///< empty: images around the plan
  bool no_images = false;
  std::vector<std::string> models;     ///< formats of building models: cityjson, citygml
  std::vector<int> strips_and_frames;  ///< of a block; empty: no block
  simulate::BlockOptions block;
  int tile_m = 100;  ///< side of a LIDAR tile of a block
};

void add_simulate_options(CLI::App& app, SimulateArguments& arguments);

/// Applies --block: sets the strips, the defaults of options that are not given, and the extent of
/// the village. Throws std::invalid_argument for options that are not allowed with a block, or
/// without one.
void set_block(const CLI::App& app, SimulateArguments& arguments);

}  // namespace ridgeline::apps
