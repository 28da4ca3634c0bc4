// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_files.h"
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

/// The name that messages give to ParameterArguments::config_text.
inline constexpr const char* kConfigInMemory = "config";

/// What a user gives to choose the parameters.
struct ParameterArguments {
  std::string preset = "default";
  std::string config;
  std::string config_text;  ///< a config file in memory, read after `config`; no option
  std::optional<double> max_aligned_angle_deg;
  std::optional<double> lidar_sigma_m;
};

/// The parameters of the preset, changed by the config file and then by the options of the command
/// line. Throws IoError naming file, line, key and rule for a key that is unknown and for a value
/// out of its range; std::invalid_argument for an option out of its range.
Parameters read_parameters(const ParameterArguments& arguments);

std::vector<std::string> method_names();

/// The methods of a run that names none: `lines`, with the preset `published` the papers' two. The
/// last one is that of a command that takes a single method.
std::vector<std::string> default_methods(const ParameterArguments& parameters);

/// The method of that name. Throws std::invalid_argument unless it is one of method_names().
reconstruct::Method method_named(const std::string& name);

/// The matcher of that name. Throws std::invalid_argument for a name of no matcher.
reconstruct::Matcher matcher_named(const std::string& name);

/// Throws std::invalid_argument if the preset is `published` and a method is not of the papers.
void check_preset(const ParameterArguments& parameters,
                  const std::vector<reconstruct::Method>& methods);

/// The parameters of a preset, "default" or "published".
Parameters preset_parameters(const std::string& preset);

/// The keys of the group `judge` of a config file.
std::vector<std::string> judge_parameter_names();

/// The text of a config file with these parameters, each with its range and meaning.
std::string to_yaml(const Parameters& parameters);

/// The parameters as run.json records them.
nlohmann::ordered_json echo(const Parameters& parameters);

/// The options of an evaluation as run.json records them. The report reads the cloud again with
/// them.
nlohmann::ordered_json echo(const results::JudgeFilesOptions& options);

}  // namespace ridgeline::apps
