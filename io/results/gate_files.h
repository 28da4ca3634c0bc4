// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/gates/gate.h"

#include <string>

namespace ridgeline::results {

/// The gates of a file applied to a folder of results, against those of a baseline unless that is
/// empty. Throws IoError for a file's fault and for a gate that cannot decide, with its line, and
/// std::invalid_argument for a baseline of other inputs.
evaluate::GateReport apply_gate_files(const std::string& gates,
                                      const std::string& results,
                                      const std::string& baseline);

}  // namespace ridgeline::results
