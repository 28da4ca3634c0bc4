// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"

#include <span>
#include <string>

namespace ridgeline::evaluate {

/// A table of the shares of decoys that pass, by kind and distance; "" without decoys.
std::string decoys_to_terminal(std::span<const Evaluation> evaluations);

/// The figures of the decoys of one evaluation with intervals and an explanation; "" without
/// decoys.
std::string decoys_to_markdown(const Evaluation& evaluation);

/// Columns patch,method,kind,distance_m,n_lines,n_decoys,share,ci95_low,ci95_high,withheld_share,
/// n_clusters.
std::string decoys_to_csv(std::span<const Evaluation> evaluations);

/// A sentence if the lines barely fit better in place than elsewhere; "" otherwise, and if this
/// cannot be determined.
std::string following_note(const Evaluation& evaluation);

}  // namespace ridgeline::evaluate
