// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"

#include <span>
#include <string>

namespace ridgeline::evaluate {

/// How many of the decoys pass by kind and distance, in one table; "" if no lines were moved.
std::string decoys_to_terminal(std::span<const Evaluation> evaluations);

/// The decoys of one evaluation with their intervals, and what they show; "" if no lines were
/// moved.
std::string decoys_to_markdown(const Evaluation& evaluation);

/// kind,distance_m,n_lines,n_decoys,share,ci95_low,ci95_high,withheld_share,n_clusters behind
/// patch,method.
std::string decoys_to_csv(std::span<const Evaluation> evaluations);

/// A sentence for lines that fit hardly better where they lie than elsewhere; "" for others and if
/// nobody can tell.
std::string following_note(const Evaluation& evaluation);

}  // namespace ridgeline::evaluate
