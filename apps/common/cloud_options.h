// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/cloud/read_cloud.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// The points of a cloud to use, as given on the command line.
struct CloudArguments {
  std::vector<std::string> clouds;  ///< files and patterns
  std::string assume_crs;
  std::vector<int> classes;
  bool exclude_withheld = true, last_returns = false, strict = false, salvage = false;
  bool scale_to_ground = false;
  std::vector<double> bounds, origin;
  std::uint64_t max_points = 0, max_memory_mib = 0;
  std::uint64_t cloud_memory_mib = 512;
  double max_resolution_m = 0.0;
};

/// Adds `--cloud`.
CLI::Option* add_cloud_option(CLI::App& app, CloudArguments& arguments);
/// Adds `--assume-crs`.
void add_assume_crs_option(CLI::App& app, CloudArguments& arguments);
/// Adds `--scale-to-ground`.
void add_scale_to_ground_flag(CLI::App& app, CloudArguments& arguments);
/// Adds the options that select points and limit memory.
void add_cloud_filters(CLI::App& app, CloudArguments& arguments);

/// Throws std::invalid_argument for an origin that is not in whole metres and for invalid bounds.
io::ReadOptions read_options(const CloudArguments& arguments);

}  // namespace ridgeline::apps
