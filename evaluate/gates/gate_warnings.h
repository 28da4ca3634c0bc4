// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/gates/gate.h"

#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// Warnings of what fails no gate but needs a look: predicted sigmas of gated lines that are far
/// from their distances, gated lines that were moved before they were judged, a run that takes over
/// twice the time of its baseline, a baseline that no gate refers to. `applied` are the results of
/// the gates.
std::vector<std::string> gate_warnings(std::span<const Gate> gates,
                                       std::span<const GateResult> applied,
                                       const ResultFolder& results,
                                       const ResultFolder* baseline);

}  // namespace ridgeline::evaluate
