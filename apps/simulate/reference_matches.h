// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/shown_edge.h"
#include "io/project/matches_file.h"

#include <span>
#include <vector>

namespace ridgeline::simulate {

/// The edges that are clearly visible in both of the first two views, without duplicates, ordered
/// from left to right by their first point. Their contrast must have been measured. An interrupted
/// edge gives one match for each run that is visible in both views.
std::vector<ReferenceEdge> reference_matches(std::span<const ShownEdge> edges);

}  // namespace ridgeline::simulate
