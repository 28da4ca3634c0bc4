// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/gate_files.h"

#include "evaluate/files/result_folder_reader.h"
#include "io/files/yaml_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

namespace ridgeline::results {
namespace {

/// Reads one mapping of a gates file; every error names the file and the line.
class GateMap : public io::YamlMap {
 public:
  using YamlMap::YamlMap;

  [[nodiscard]] std::optional<std::string> maybe_text(const char* key) const {
    return has(key) ? std::optional(text(key)) : std::nullopt;
  }

  [[nodiscard]] std::optional<double> maybe_number(const char* key) const {
    return has(key) ? std::optional(number(key)) : std::nullopt;
  }

  [[nodiscard]] std::optional<int> count(const char* key) const {
    const std::optional<double> value = maybe_number(key);
    if (!value) return std::nullopt;
    if (*value < 1.0 || *value > std::numeric_limits<int>::max() || std::floor(*value) != *value)
      fail(key, fmt::format("{} = {}; must be a whole number >= 1", key, *value));
    return static_cast<int>(*value);
  }

  [[nodiscard]] std::optional<double> allowance(const char* key) const {
    const std::optional<double> value = maybe_number(key);
    if (value && *value < 0.0) fail(key, fmt::format("{} = {}; must be >= 0", key, *value));
    return value;
  }

  [[nodiscard]] std::optional<evaluate::BaselineIncrease> increase(const char* key) const {
    if (!has(key)) return std::nullopt;
    const YAML::Node value = node(key);
    if (value.IsScalar() && value.Scalar() == "default") return evaluate::BaselineIncrease{};
    return evaluate::BaselineIncrease{allowance(key)};
  }

  [[nodiscard]] evaluate::GateBound bound(const char* key) const {
    using enum evaluate::GateBound;
    const std::string found = maybe_text(key).value_or(name(kPoint));
    if (found == name(kUpper95)) return kUpper95;
    if (found != name(kPoint))
      fail(key, fmt::format("{} = {}; must be point or upper95", key, found));
    return kPoint;
  }

  [[nodiscard]] std::optional<evaluate::DecidedGroup> decided_group(const char* key) const {
    const std::optional<std::string> found = maybe_text(key);
    if (!found) return std::nullopt;
    const auto* const group = std::ranges::find_if(
        evaluate::kDecidedGroups, [&](const auto& known) { return *found == name(known); });
    if (group == std::end(evaluate::kDecidedGroups))
      fail(key, fmt::format("{} = {}; must be plan_images or points_place", key, *found));
    return *group;
  }
};

evaluate::Gate read_gate(const std::string& path,
                         const YAML::Node& node,
                         const std::optional<int>& n_min) {
  const GateMap map(path, node,
                    {"patch", "method", "class", "metric", "n_images", "decided_by", "within_m",
                     "kind", "distance_m", "bound", "max", "min", "max_ratio_to", "ratio",
                     "max_increase_over_baseline", "max_decrease_below_baseline", "n_min"});
  evaluate::Gate gate;
  gate.patch = map.maybe_text("patch");
  gate.method = map.maybe_text("method");
  gate.line_class = map.maybe_text("class").value_or(gate.line_class);
  gate.n_images = map.count("n_images");
  gate.decided_by = map.decided_group("decided_by");
  gate.metric = map.maybe_text("metric").value_or(gate.metric);
  gate.within_m = map.maybe_number("within_m");
  gate.kind = map.maybe_text("kind");
  gate.distance_m = map.maybe_number("distance_m");
  gate.bound = map.bound("bound");
  gate.max = map.maybe_number("max");
  gate.min = map.maybe_number("min");
  if (map.has("max_ratio_to"))
    gate.max_ratio_to_class = GateMap(path, map.node("max_ratio_to"), {"class"}).text("class");
  else if (map.has("ratio"))
    map.fail("ratio", "ratio without max_ratio_to, which names the class to relate to");
  gate.ratio = map.maybe_number("ratio").value_or(gate.ratio);
  gate.max_increase_over_baseline = map.increase("max_increase_over_baseline");
  gate.max_decrease_below_baseline = map.allowance("max_decrease_below_baseline");
  if (const std::optional<int> own = map.count("n_min"); own || n_min)
    gate.n_min = static_cast<std::size_t>(own ? *own : *n_min);
  try {
    validate(gate);
  } catch (const std::invalid_argument& error) {
    io::fail_yaml(path, node, error.what());
  }
  return gate;
}

std::vector<evaluate::Gate> gates_of(const YAML::Node& root, const std::string& path) {
  const GateMap map(path, root, {"n_min", "gates"});
  const YAML::Node list = map.node("gates");
  if (!list.IsSequence() || list.size() == 0)
    map.fail("gates", "gates must be a list of at least one gate");
  const std::optional<int> n_min = map.count("n_min");
  std::vector<evaluate::Gate> gates;
  for (const YAML::Node& node : list) gates.push_back(read_gate(path, node, n_min));
  return gates;
}

}  // namespace

std::vector<evaluate::Gate> read_gates(const std::string& file) {
  return gates_of(io::load_yaml(file, io::FileGroup::kGates), file);
}

std::vector<evaluate::Gate> parse_gates(const std::string& content, const std::string& name) {
  return gates_of(io::parse_yaml(content, name), name);
}

evaluate::GateReport apply_gate_files(const std::string& gates_file,
                                      const std::string& results_folder,
                                      const std::string& baseline_folder) {
  const std::vector<evaluate::Gate> gates = read_gates(gates_file);
  const evaluate::ResultFolder results = read_result_folder(results_folder);
  if (baseline_folder.empty()) return evaluate::apply_gates(gates, results);
  const evaluate::ResultFolder baseline = read_result_folder(baseline_folder);
  return evaluate::apply_gates(gates, results, &baseline);
}

}  // namespace ridgeline::results
