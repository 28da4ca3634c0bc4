// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/gates/gate.h"

#include <string>
#include <vector>

namespace ridgeline::results {

/// Reads the gates of a YAML file {n_min, gates: [{patch, method, class, metric, n_images,
/// decided_by, within_m, kind, distance_m, bound, max, min, max_ratio_to: {class}, ratio,
/// max_increase_over_baseline, max_decrease_below_baseline, n_min}, ...]}; the top-level n_min is
/// the default for all gates. Throws IoError for a file that cannot be read or is not YAML, an
/// unknown or repeated key, a value of the wrong type, an empty list of gates, and a gate that
/// validate() rejects, naming its line.
std::vector<evaluate::Gate> read_gates(const std::string& file);
/// Parses the content of a gates file; `name` identifies it in messages. Throws like read_gates().
std::vector<evaluate::Gate> parse_gates(const std::string& content, const std::string& name);

/// Applies the gates of a file to a results folder. `baseline`: another results folder, or empty.
/// Throws like read_gates(), and std::invalid_argument for a baseline with other inputs.
evaluate::GateReport apply_gate_files(const std::string& gates,
                                      const std::string& results,
                                      const std::string& baseline);

}  // namespace ridgeline::results
