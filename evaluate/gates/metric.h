// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/summary.h"
#include "evaluate/tables/table1.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::evaluate {

/// Names of the figures of a class that can be gated: rms_m, q95_m, evaluated_share, ...
std::vector<std::string_view> accuracy_metrics();

/// Names of the matching figures that can be gated: correctness, completeness, quality.
std::vector<std::string_view> matching_metrics();

bool is_accuracy_metric(std::string_view metric);
bool is_matching_metric(std::string_view metric);

/// A figure by its name; empty if the cell does not have it.
/// Throws std::invalid_argument for a name that is not in accuracy_metrics().
std::optional<double> metric_value(const Summary& summary, std::string_view metric);

/// Throws std::invalid_argument for a name that is not in matching_metrics().
std::optional<double> metric_value(const MatchCounts& counts, std::string_view metric);

/// Number of lines that a figure rests on: all lines for a share of them, else those evaluated.
std::size_t metric_count(const Summary& summary, std::string_view metric);

}  // namespace ridgeline::evaluate
