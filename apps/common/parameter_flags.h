// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/pipeline/parameters.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace ridgeline::apps {

void add_preset_option(CLI::App& app, std::string& preset);
/// Adds `--config`, unless the command has it already.
void add_config_option(CLI::App& app, std::string& config);
/// Adds `--max-aligned-angle-deg`.
void add_class_option(CLI::App& app, ParameterArguments& arguments);
/// Adds `--preset`, `--config` and `--max-aligned-angle-deg`.
void add_method_options(CLI::App& app, ParameterArguments& arguments);
/// Adds `--config` and `--lidar-sigma-m`.
void add_judge_options(CLI::App& app, ParameterArguments& arguments);
/// Adds `--matcher`, which takes one matcher, or both separated by a comma.
void add_matcher_option(CLI::App& app, std::vector<std::string>& names);

}  // namespace ridgeline::apps
