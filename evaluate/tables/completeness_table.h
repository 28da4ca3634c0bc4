// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/evaluation.h"

#include <span>
#include <string>

namespace ridgeline::evaluate {

/// The share of the scan's edges that the lines of each evaluation have found, by kind; "" if it
/// was not determined.
std::string completeness_to_terminal(std::span<const Evaluation> evaluations);

/// The figures of one evaluation with intervals, and what they mean; "" if there are none.
std::string completeness_to_markdown(const Evaluation& evaluation);

/// Columns patch,method,kind,length,n,n_found,recall,ci95_low,ci95_high,n_clusters,length_m,
/// covered_m,recall_length,n_not_in_images,n_lines,n_lines_without_edge,area_from,area_m2.
std::string completeness_to_csv(std::span<const Evaluation> evaluations);

}  // namespace ridgeline::evaluate
