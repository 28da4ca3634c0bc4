// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/pipeline/parameters.h"
#include "apps/run/patch_run.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace ridgeline::apps {

/// RunOptions as given on the command line.
struct RunFlags {
  std::vector<std::string> methods;  ///< if empty, default_methods()
  std::string matcher = "pairwise";
  std::vector<std::string> line_formats;
  std::string schema = "plain";
  ParameterArguments parameters;
  RunOptions options;
};

/// Adds the flags that `block` and `run` have in common.
void add_block_flags(CLI::App& app, RunFlags& flags);
/// Adds these and the flags of `run` only.
void add_run_flags(CLI::App& app, RunFlags& flags);

/// Throws std::invalid_argument for values out of range.
RunOptions run_options(const RunFlags& flags);

}  // namespace ridgeline::apps
