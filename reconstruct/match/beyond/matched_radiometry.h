// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/strip_appearance.h"
#include "reconstruct/geometry/epipolar_transfer.h"
#include "reconstruct/match/candidates.h"
#include "reconstruct/scene/scene.h"

namespace ridgeline::reconstruct {

/// A radiometry refined by means of surfaces that both images show. The moments of all flanks
/// (relative_radiometry) also include what only one image shows, above all walls, and are therefore
/// off by a few hundredths of the range of grey values. This function uses the best candidates of
/// the longest segments. If a side has the same texture in both images (which does not depend on
/// gain and offset), it gives the colours of one surface in both images. For each band, a straight
/// line is fitted robustly to these colours. A band with too few of them, or without contrast,
/// keeps its first values.
Radiometry matched_radiometry(const SearchedPair& pair,
                              const Radiometry& first,
                              const CandidateOptions& options,
                              const CandidateAppearance& change_appearance = {});

}  // namespace ridgeline::reconstruct
