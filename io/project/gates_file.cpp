// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/gates_file.h"

#include "io/error.h"
#include "io/files/yaml_check.h"
#include "io/text/nearest_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

namespace ridgeline::io {
namespace {

/// Reads the nodes of one file; every error names the file and the line.
class GatesReader {
 public:
  explicit GatesReader(std::string path) : path_(std::move(path)) {}

  [[nodiscard]] std::vector<GateEntry> read(const YAML::Node& root) const {
    if (!root.IsMap()) fail(root, "the file holds no map; it must hold a list named gates");
    check_keys(root, {"n_min", "gates"});
    const YAML::Node gates = root["gates"];
    if (!gates || !gates.IsSequence() || gates.size() == 0) {
      fail(root, "no gates; the file must hold a list named gates with at least one entry");
    }
    std::vector<GateEntry> entries;
    for (const YAML::Node& node : gates) entries.push_back(entry(node));
    const std::optional<int> n_min = count(root, "n_min");
    for (GateEntry& entry : entries) {
      if (!entry.n_min) entry.n_min = n_min;
    }
    return entries;
  }

 private:
  [[noreturn]] void fail(const YAML::Node& node, const std::string& message) const {
    const YAML::Mark mark = node.Mark();
    throw IoError(path_,
                  mark.is_null() ? message : fmt::format("line {}: {}", mark.line + 1, message));
  }

  void check_keys(const YAML::Node& map, const std::vector<std::string_view>& known) const {
    std::set<std::string> seen;
    for (const auto& item : map) {
      const std::string key = item.first.IsScalar() ? item.first.Scalar() : "(not a word)";
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        fail(item.first, fmt::format("unknown key {}, the nearest is {}; known keys: {}", key,
                                     nearest_name(key, known), fmt::join(known, ", ")));
      }
      if (!seen.insert(key).second) fail(item.first, "key " + key + ": given twice");
    }
  }

  [[nodiscard]] std::optional<std::string> text(const YAML::Node& map, const char* key) const {
    const YAML::Node node = map[key];
    if (!node) return std::nullopt;
    if (!node.IsScalar() || node.Scalar().empty()) fail(node, fmt::format("{}: must be text", key));
    return node.Scalar();
  }

  [[nodiscard]] double as_number(const YAML::Node& node, const char* key) const {
    double value = std::numeric_limits<double>::quiet_NaN();
    const bool is_number = node.IsScalar() && YAML::convert<double>::decode(node, value);
    if (!is_number || !std::isfinite(value)) {
      fail(node, fmt::format("{}: {}; must be a finite number", key,
                             node.IsScalar() ? node.Scalar() : "not a number"));
    }
    return value;
  }

  [[nodiscard]] std::optional<double> number(const YAML::Node& map, const char* key) const {
    const YAML::Node node = map[key];
    return node ? std::optional(as_number(node, key)) : std::nullopt;
  }

  [[nodiscard]] std::optional<int> count(const YAML::Node& map, const char* key) const {
    const std::optional<double> value = number(map, key);
    if (!value) return std::nullopt;
    constexpr double kMax = std::numeric_limits<int>::max();
    if (*value < 1.0 || *value > kMax || std::floor(*value) != *value) {
      fail(map[key], fmt::format("{}: {}; must be a whole number >= 1", key, *value));
    }
    return static_cast<int>(*value);
  }

  [[nodiscard]] std::optional<double> allowance(const YAML::Node& map, const char* key) const {
    const std::optional<double> value = number(map, key);
    if (value && *value < 0.0) fail(map[key], fmt::format("{}: {}; must be >= 0", key, *value));
    return value;
  }

  [[nodiscard]] std::optional<GateEntry::Increase> increase(const YAML::Node& map,
                                                            const char* key) const {
    const YAML::Node node = map[key];
    if (!node) return std::nullopt;
    if (node.IsScalar() && node.Scalar() == "default") return GateEntry::Increase{};
    return GateEntry::Increase{allowance(map, key)};
  }

  [[nodiscard]] std::optional<std::string> ratio_class(const YAML::Node& map) const {
    const YAML::Node node = map["max_ratio_to"];
    if (!node) return std::nullopt;
    if (!node.IsMap()) fail(node, "max_ratio_to: must be a map such as {class: not_aligned}");
    check_keys(node, {"class"});
    std::optional<std::string> name = text(node, "class");
    if (!name) fail(node, "max_ratio_to: no class; it must name one");
    return name;
  }

  [[nodiscard]] std::optional<std::string> bound(const YAML::Node& map) const {
    std::optional<std::string> bound = text(map, "bound");
    if (bound && bound != "point" && bound != "upper95") {
      fail(map["bound"], "bound: " + *bound + "; must be point or upper95");
    }
    return bound;
  }

  [[nodiscard]] GateEntry entry(const YAML::Node& map) const {
    if (!map.IsMap())
      fail(map, "a gate must be a map such as {class: total, metric: rms_m, max: 0.3}");
    check_keys(map, {"patch", "method", "class", "metric", "n_images", "decided_by", "within_m",
                     "kind", "distance_m", "bound", "max", "min", "max_ratio_to", "ratio",
                     "max_increase_over_baseline", "max_decrease_below_baseline", "n_min"});
    GateEntry entry;
    entry.line = map.Mark().line + 1;
    entry.patch = text(map, "patch");
    entry.method = text(map, "method");
    entry.line_class = text(map, "class");
    entry.n_images = count(map, "n_images");
    entry.decided_by = text(map, "decided_by");
    entry.metric = text(map, "metric");
    entry.within_m = number(map, "within_m");
    entry.kind = text(map, "kind");
    entry.distance_m = number(map, "distance_m");
    entry.bound = bound(map);
    entry.max = number(map, "max");
    entry.min = number(map, "min");
    entry.max_ratio_to_class = ratio_class(map);
    entry.ratio = number(map, "ratio");
    entry.max_increase_over_baseline = increase(map, "max_increase_over_baseline");
    entry.max_decrease_below_baseline = allowance(map, "max_decrease_below_baseline");
    entry.n_min = count(map, "n_min");
    if (entry.ratio && !entry.max_ratio_to_class) {
      fail(map["ratio"], "ratio: without max_ratio_to; it needs the class to relate to");
    }
    return entry;
  }

  std::string path_;
};

}  // namespace

std::vector<GateEntry> read_gates_file(const std::filesystem::path& path) {
  return GatesReader(path.string()).read(load_yaml(path.string(), Expected::kGates));
}

std::vector<GateEntry> parse_gates(const std::string& content, const std::string& path) {
  return GatesReader(path).read(parse_yaml(content, path));
}

}  // namespace ridgeline::io
