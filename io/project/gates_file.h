// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::io {

/// One entry of a gates file, as written. What the file does not say stays empty.
struct GateEntry {
  /// How far a figure may rise above its baseline; without a value the file has the word `default`.
  struct Increase {
    std::optional<double> value;
  };

  int line = 0;  ///< line of the file, from 1
  std::optional<std::string> patch, method, line_class, metric;
  std::optional<double> max, min;
  std::optional<std::string> max_ratio_to_class;
  std::optional<double> ratio;
  std::optional<Increase> max_increase_over_baseline;
  std::optional<double> max_decrease_below_baseline;
  std::optional<int> n_images;
  std::optional<std::string> decided_by;
  std::optional<double> within_m;
  std::optional<std::string> kind, bound;
  std::optional<double> distance_m;
  std::optional<int> n_min;  ///< the entry's own, else the file's
};

/// Reads a YAML file {n_min, gates: [{class, n_images, decided_by, within_m, kind, distance_m,
/// bound, patch, method, metric, max, min, max_ratio_to: {class}, ratio,
/// max_increase_over_baseline, max_decrease_below_baseline, n_min}, ...]}; n_min beside `gates` is
/// that of every entry without one. Throws IoError for a file that cannot be read or is not YAML,
/// an unknown or repeated key (naming the nearest and all known ones), a value of the wrong type,
/// or an empty list of gates.
std::vector<GateEntry> read_gates_file(const std::filesystem::path& path);
/// Reads gates from a text as read_gates_file() does from a file; `path` is what messages call it.
std::vector<GateEntry> parse_gates(const std::string& content, const std::string& path);

}  // namespace ridgeline::io
