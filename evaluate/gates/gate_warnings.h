// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/gates/gate.h"

#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// Warnings about findings that fail no gate but should be checked: predicted sigmas of gated lines
/// that disagree strongly with the measured distances, gated lines that were moved before they were
/// judged, a run that takes more than twice as long as its baseline, a baseline that no gate refers
/// to. `applied`: the gate results.
std::vector<std::string> gate_warnings(std::span<const Gate> gates,
                                       std::span<const GateResult> applied,
                                       const ResultFolder& results,
                                       const ResultFolder* baseline);

}  // namespace ridgeline::evaluate
