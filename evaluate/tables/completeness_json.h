// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/completeness.h"
#include "evaluate/tables/summary_json.h"

#include <Eigen/Core>

namespace ridgeline::evaluate {

/// The completeness in the format of `evaluation.METHOD.json`: the area, the rows, and the edges
/// that count, with their ends in the world frame.
Json completeness_json(const Completeness& completeness, const Eigen::Vector3d& origin_m);
/// Reads the output of completeness_json(). Throws std::invalid_argument for anything else.
Completeness parse_completeness(const Json& json, const Eigen::Vector3d& origin_m);

}  // namespace ridgeline::evaluate
