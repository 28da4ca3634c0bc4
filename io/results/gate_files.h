// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/gates/gate.h"

#include <string>
#include <vector>

namespace ridgeline::results {

/// The gates of a file. Throws IoError for a file's fault and for a gate that cannot decide, with its line.
std::vector<evaluate::Gate> read_gates(const std::string& file);
/// The same of a text; `name` is what messages call it.
std::vector<evaluate::Gate> parse_gates(const std::string& content, const std::string& name);

/// The gates of a file applied to a folder of results, against those of a baseline unless that is
/// empty. Throws as read_gates(), and std::invalid_argument for a baseline of other inputs.
evaluate::GateReport apply_gate_files(const std::string& gates,
                                      const std::string& results,
                                      const std::string& baseline);

}  // namespace ridgeline::results
