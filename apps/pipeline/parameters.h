// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/judge/options.h"
#include "reconstruct/reconstruct.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

/// All that a config file holds: the parameters of the reconstruction and of the judge.
struct Parameters {
  reconstruct::Options method;
  evaluate::JudgeOptions judge;
};

/// What messages call ParameterArguments::config_text.
inline constexpr const char* kConfigInMemory = "config";

/// How a user chooses them on the command line.
struct ParameterArguments {
  std::string preset = "default";
  std::string config;
  std::string config_text;  ///< the same in memory, read after the file; no option
  std::optional<double> max_aligned_angle_deg;
  std::optional<double> lidar_sigma_m;
};

/// Those of the preset, changed by the config file and then by the options of the command line. Throws IoError naming
/// file, line, key and rule for a key that is unknown and for a value out of its range; std::invalid_argument for an
/// option out of its range.
Parameters read_parameters(const ParameterArguments& arguments);

std::vector<std::string> method_names();

/// Throws std::invalid_argument for none of method_names().
reconstruct::Method method_named(const std::string& name);

/// In the order of the enum, each once. Throws std::invalid_argument for a name of no matcher.
std::vector<reconstruct::Matcher> matchers_named(const std::vector<std::string>& names);

/// Throws std::invalid_argument for a method that is none of the papers' under `--preset published`.
void check_preset(const ParameterArguments& parameters,
                  const std::vector<reconstruct::Method>& methods);

/// "default" | "published".
Parameters preset_parameters(const std::string& preset);

/// The keys of the group `judge` of a config file.
std::vector<std::string> judge_parameter_names();

/// The config file of these parameters, each with its range and meaning.
std::string to_yaml(const Parameters& parameters);

/// The same for run.json.
nlohmann::ordered_json echo(const Parameters& parameters);

}  // namespace ridgeline::apps
