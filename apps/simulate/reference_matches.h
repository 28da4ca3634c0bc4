// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/shown_edge.h"
#include "io/project/matches_file.h"

#include <opencv2/core/mat.hpp>

#include <span>
#include <vector>

namespace ridgeline::simulate {

/// The edges that both of the first two views show clearly, without duplicates, ordered from left to right by their first
/// point. `images`: of all views, as written. An edge that is interrupted gives one match for each run that both
/// see.
std::vector<io::ReferenceEdge> reference_matches(std::span<const ShownEdge> edges,
                                                 std::span<const cv::Mat> images,
                                                 const ReferenceOptions& options = {});

}  // namespace ridgeline::simulate
