// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/gates/gate.h"

#include <string>
#include <vector>

namespace ridgeline::results {

/// The gates of a YAML file {n_min, gates: [{patch, method, class, metric, n_images, decided_by,
/// within_m, kind, distance_m, bound, max, min, max_ratio_to: {class}, ratio,
/// max_increase_over_baseline, max_decrease_below_baseline, n_min}, ...]}; n_min beside `gates` is
/// that of every gate without one. Throws IoError for a file that cannot be read or is not YAML, an
/// unknown or repeated key, a value of the wrong type, an empty list of gates, and for a gate that
/// cannot decide, with its line.
std::vector<evaluate::Gate> read_gates(const std::string& file);
/// The gates of a gates file's content; `name` is what messages call it. Throws as read_gates()
/// does.
std::vector<evaluate::Gate> parse_gates(const std::string& content, const std::string& name);

/// Applies the gates of a file to a folder of results, with a folder of results as baseline unless
/// that is empty. Throws as read_gates() does, and std::invalid_argument for a baseline of other
/// inputs.
evaluate::GateReport apply_gate_files(const std::string& gates,
                                      const std::string& results,
                                      const std::string& baseline);

}  // namespace ridgeline::results
