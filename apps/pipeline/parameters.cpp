// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/parameters.h"

#include "io/files/yaml_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ridgeline::apps {
namespace {

using evaluate::SampleConsensus;
using reconstruct::Matcher;

constexpr std::array kConsensus{std::pair{"msac", SampleConsensus::kMsac},
                                std::pair{"ransac", SampleConsensus::kRansac},
                                std::pair{"prosac", SampleConsensus::kProsac}};
constexpr const char* kConsensusKey = "sample_consensus";

const char* name(SampleConsensus method) {
  for (const auto& [text, value] : kConsensus) {
    if (value == method) return text;
  }
  return "";
}

/// Calls visit(group, field, value) for every parameter, in file order.
template <typename Visitor>
void for_each_parameter(Parameters& p, Visitor&& visit) {
  const auto group = [&](const char* of_file, auto& options) {
    for_each_field<std::decay_t<decltype(options)>>(
        [&](const auto& field) { visit(of_file, field, options.*field.member); });
  };
  group("extract", p.method.extraction.edges);
  group("extract", p.method.extraction.beyond);
  group("match", p.method.matching.candidates);
  group("match", p.method.matching.pairwise);
  group("match", p.method.matching.beyond);
  group("tracks", p.method.matching.tracks);
  group("chio", p.method.matching.chio);
  group("chio", p.method.matching.beyond_chio);
  group("reconstruct", p.method.estimation.lines);
  group("reconstruct", p.method.estimation.beyond);
  group("reconstruct", p.method.estimation.building);
  group("reconstruct", p.method.estimation.consensus);
  group("judge", p.judge);
}

constexpr std::array kGroups{
    std::pair{"extract", "line segments of an image (Ok et al. 2011, section 2)"},
    std::pair{"match", "pair-wise matching (Ok et al. 2011)"},
    std::pair{"tracks", "lines in three images and more"},
    std::pair{"chio", "matching and linking in object space (Chio and Wang 2000)"},
    std::pair{"reconstruct", "3D lines (Ok et al. 2011, section 3)"},
    std::pair{"judge", "lines against LIDAR planes"}};

std::vector<std::string_view> keys_of(Parameters& p, std::string_view group) {
  std::vector<std::string_view> keys;
  for_each_parameter(p, [&](std::string_view of, const auto& field, auto&) {
    if (of == group) keys.push_back(field.name);
  });
  if (group == "judge") keys.emplace_back(kConsensusKey);
  return keys;
}

bool read_switch(const io::YamlMap& map, const char* key) {
  const std::string text = map.text(key);
  if (text == "true" || text == "1") return true;
  if (text != "false" && text != "0")
    map.fail(key, fmt::format("{} = {}, must be true or false", key, text));
  return false;
}

template <typename Field, typename T>
void read_value(const io::YamlMap& map, const Field& field, T& value) {
  const std::string key(field.name);
  if constexpr (std::is_same_v<T, bool>) {
    value = read_switch(map, key.c_str());
  } else {
    const double number = map.number(key.c_str());
    const bool fits = number >= static_cast<double>(field.lowest) &&
                      number <= static_cast<double>(field.highest) &&
                      (std::is_floating_point_v<T> || number == std::floor(number));
    if (!fits) {
      map.fail(key.c_str(),
               fmt::format("{} = {:g}, must be {}in [{:g}, {:g}]", key, number,
                           std::is_floating_point_v<T> ? "" : "a whole number ",
                           static_cast<double>(field.lowest), static_cast<double>(field.highest)));
    }
    value = static_cast<T>(number);
  }
}

void read_consensus(const io::YamlMap& map, evaluate::JudgeOptions& judge) {
  const std::string text = map.text(kConsensusKey);
  for (const auto& [known, value] : kConsensus) {
    if (text == known) {
      judge.method = value;
      return;
    }
  }
  map.fail(kConsensusKey,
           fmt::format("{} = {}, must be msac, ransac or prosac", kConsensusKey, text));
}

void read_config(const std::string& file, const YAML::Node& node, Parameters& parameters) {
  std::vector<std::string_view> groups;
  groups.reserve(kGroups.size());
  for (const auto& [group, meaning] : kGroups) groups.emplace_back(group);
  const io::YamlMap root(file, node, groups);
  for (const auto& [group, meaning] : kGroups) {
    if (!root.has(group)) continue;
    const io::YamlMap map(file, root.node(group), keys_of(parameters, group));
    for_each_parameter(parameters, [&, in = std::string_view(group)](
                                       std::string_view of, const auto& field, auto& value) {
      if (of == in && map.has(std::string(field.name).c_str())) read_value(map, field, value);
    });
    if (std::string_view(group) == "judge" && map.has(kConsensusKey)) {
      read_consensus(map, parameters.judge);
    }
  }
}

template <typename Field, typename T>
std::string yaml_line(const Field& field, const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return fmt::format("  {}: {}  # {}\n", field.name, value, field.help);
  } else {
    return fmt::format("  {}: {}  # {}; {:g} to {:g}\n", field.name, value, field.help,
                       static_cast<double>(field.lowest), static_cast<double>(field.highest));
  }
}

}  // namespace

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  names.reserve(reconstruct::kMethods.size());
  for (const reconstruct::Method method : reconstruct::kMethods) {
    names.emplace_back(reconstruct::name(method));
  }
  return names;
}

std::vector<std::string> default_methods(const ParameterArguments& parameters) {
  if (parameters.preset == "published") return {"direct", "joint"};
  return {reconstruct::name(reconstruct::Method::kLines)};
}

reconstruct::Method method_named(const std::string& name) {
  for (const reconstruct::Method method : reconstruct::kMethods) {
    if (name == reconstruct::name(method)) return method;
  }
  throw std::invalid_argument(
      fmt::format("method = {}, must be one of {}", name, fmt::join(method_names(), ", ")));
}

Matcher matcher_named(const std::string& name) {
  for (const Matcher matcher : {Matcher::kPairwise, Matcher::kChio}) {
    if (name == reconstruct::name(matcher)) return matcher;
  }
  throw std::invalid_argument(fmt::format("matcher = {}, must be pairwise or chio", name));
}

void check_preset(const ParameterArguments& parameters,
                  const std::vector<reconstruct::Method>& methods) {
  if (parameters.preset != "published") return;
  for (const reconstruct::Method method : methods) {
    check(method == reconstruct::Method::kDirect || method == reconstruct::Method::kJoint,
          "`preset` published: ", reconstruct::name(method),
          " is not a method of the papers; must be direct or joint");
  }
}

Parameters preset_parameters(const std::string& preset) {
  Parameters parameters;
  if (preset != "published") return parameters;
  parameters.method = reconstruct::published();
  parameters.judge.method = SampleConsensus::kRansac;
  return parameters;
}

Parameters read_parameters(const ParameterArguments& arguments) {
  Parameters parameters = preset_parameters(arguments.preset);
  if (!arguments.config.empty()) {
    read_config(arguments.config, io::load_yaml(arguments.config, io::FileGroup::kConfig),
                parameters);
  }
  if (!arguments.config_text.empty()) {
    read_config(kConfigInMemory, io::parse_yaml(arguments.config_text, kConfigInMemory),
                parameters);
  }
  if (arguments.max_aligned_angle_deg) {
    parameters.method.estimation.lines.max_aligned_angle_deg = *arguments.max_aligned_angle_deg;
  }
  if (arguments.lidar_sigma_m) parameters.judge.lidar_sigma_m = *arguments.lidar_sigma_m;
  validate(parameters.method);
  validate(parameters.judge);
  return parameters;
}

std::vector<std::string> judge_parameter_names() {
  Parameters p;
  const std::vector<std::string_view> keys = keys_of(p, "judge");
  return {keys.begin(), keys.end()};
}

std::string to_yaml(const Parameters& parameters) {
  std::string text = "# Parameters of ridgeline: value  # meaning; range. All are optional.\n";
  Parameters p = parameters;
  for (const auto& [group, meaning] : kGroups) {
    text += fmt::format("\n{}:  # {}\n", group, meaning);
    for_each_parameter(
        p, [&, in = std::string_view(group)](std::string_view of, const auto& field, auto& value) {
          if (of == in) text += yaml_line(field, value);
        });
  }
  return text + fmt::format("  {}: {}  # sample consensus of PCL: msac, ransac or prosac\n",
                            kConsensusKey, name(parameters.judge.method));
}

nlohmann::ordered_json echo(const Parameters& parameters) {
  nlohmann::ordered_json json;
  Parameters p = parameters;
  for_each_parameter(p, [&](const char* group, const auto& field, auto& value) {
    json[group][std::string(field.name)] = value;
  });
  json["judge"][kConsensusKey] = name(parameters.judge.method);
  return json;
}

nlohmann::ordered_json echo(const results::JudgeFilesOptions& options) {
  const io::ReadOptions& cloud = options.cloud;
  nlohmann::ordered_json json;
  json["lines"] = options.line_paths;
  json["cloud"] = options.cloud_paths;
  json["patch"] = options.patch ? options.patch->path : "";
  json["classes"] = cloud.classes ? std::vector<int>(cloud.classes->begin(), cloud.classes->end())
                                  : std::vector<int>{};
  json["exclude_withheld"] = cloud.exclude_withheld;
  json["last_returns"] = cloud.last_returns;
  json["bounds"] = nlohmann::ordered_json::array();
  if (const auto& box = cloud.bounds_in_file) {
    json["bounds"] = {box->min().x(), box->min().y(), box->max().x(), box->max().y()};
  }
  json["max_resolution_m"] = cloud.max_resolution_m;
  if (options.area) {
    const auto& [low, high] = std::pair(options.area->min(), options.area->max());
    json["area"] = {low.x(), low.y(), high.x(), high.y()};
    json["strict"] = cloud.strict;
    json["salvage"] = cloud.salvage;
    json["bca"] = options.summary.bootstrap.bca;
  }
  json["assume_crs"] = cloud.assume_crs.definition;
  json["scale_to_ground"] = options.scale_to_ground;
  json["vertex_pairs"] = options.lines.vertex_pairs;
  json["lod"] = options.lines.lod;
  json["id"] = options.lines.id_column;
  json["building"] = options.lines.building_column;
  json["by"] = options.by;
  json["apply_shift"] = options.apply_shift;
  if (options.n_decoys) json["decoys"] = *options.n_decoys;
  if (options.completeness) json["completeness"] = true;
  json["geoid"] = options.geoid;
  json["reconstruct"]["max_aligned_angle_deg"] = options.max_aligned_angle_deg;
  json["judge"] = echo(Parameters{{}, options.judge})["judge"];
  json["gross_m"] = options.summary.gross_m;
  json["sigma_sys_m"] = options.summary.sigma_sys_m;
  json["bootstrap_replicates"] = options.summary.bootstrap.replicates;
  json["bootstrap_seed"] = options.summary.bootstrap.seed;
  return json;
}

}  // namespace ridgeline::apps
