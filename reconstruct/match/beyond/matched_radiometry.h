// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/strip_appearance.h"
#include "reconstruct/geometry/epipolar_transfer.h"
#include "reconstruct/match/candidates.h"
#include "reconstruct/scene/scene.h"

namespace ridgeline::reconstruct {

/// A radiometry refined by surfaces that both images show. The moments of all flanks
/// (relative_radiometry) also count what one image alone shows, above all walls, and are therefore
/// off by a few hundredths of the range of grey values. This function uses the best candidates of
/// the longest segments. If a side has the same texture in both images, which no gain or offset
/// changes, it gives the colours of one surface in both images. A straight line per band is fitted
/// to these colours, robustly. A band without enough of them, or without contrast, keeps its first
/// values.
Radiometry matched_radiometry(const SearchedPair& pair,
                              const Radiometry& first,
                              const CandidateOptions& options,
                              const CandidateAppearance& change_appearance = {});

}  // namespace ridgeline::reconstruct
