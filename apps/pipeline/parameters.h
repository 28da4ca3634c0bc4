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

/// The content of a config file: the parameters of the reconstruction and of the judge.
struct Parameters {
  reconstruct::Options method;
  evaluate::JudgeOptions judge;
};

/// The name of ParameterArguments::config_text in messages.
inline constexpr const char* kConfigInMemory = "config";

/// The user's choice of parameters.
struct ParameterArguments {
  std::string preset = "default";
  std::string config;
  /// A config file in memory, read after `config`; not a command-line option.
  std::string config_text;
  std::optional<double> max_aligned_angle_deg;
  std::optional<double> lidar_sigma_m;
};

/// The parameters of the preset, modified by the config file and then by the command-line options.
/// Throws IoError naming file, line, key and rule for an unknown key and for a value out of range;
/// std::invalid_argument for an option out of range.
Parameters read_parameters(const ParameterArguments& arguments);

std::vector<std::string> method_names();

/// The default methods of a run: `lines`, or the papers' two with the preset `published`. The last
/// one is the default of a command that takes a single method.
std::vector<std::string> default_methods(const ParameterArguments& parameters);

/// The method of that name. Throws std::invalid_argument unless it is one of method_names().
reconstruct::Method method_named(const std::string& name);

/// The matcher of that name. Throws std::invalid_argument for an unknown name.
reconstruct::Matcher matcher_named(const std::string& name);

/// Throws std::invalid_argument if the preset is `published` and a method is not from the papers.
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

/// The options of an evaluation as run.json records them. The report uses them to read the cloud
/// again.
nlohmann::ordered_json echo(const results::JudgeFilesOptions& options);

}  // namespace ridgeline::apps
