// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/chio_wang2000/fitted_line.h"
#include "reconstruct/chio_wang2000/options.h"
#include "reconstruct/views/epipolar_transfer.h"
#include "reconstruct/views/match_view.h"

#include <optional>
#include <span>

namespace ridgeline::reconstruct {

/// The 3D line through the reliable points of the chains of a left segment with right ones: the
/// orthogonal regression of fit_line(). To its covariance comes what all points of a link have in
/// common, the uncertainty of the first right line, which moves them along their rays and tilts them.
/// Empty for fewer than three reliable points.
std::optional<FittedLine> line_through_links(int left_id,
                                             std::span<const int> right_ids,
                                             const SearchedPair& pair,
                                             double gsd_m,
                                             const ChioOptions& options);

}  // namespace ridgeline::reconstruct
