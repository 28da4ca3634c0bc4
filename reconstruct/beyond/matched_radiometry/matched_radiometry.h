// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/views/candidates.h"
#include "reconstruct/views/epipolar_transfer.h"
#include "reconstruct/views/scene.h"
#include "reconstruct/views/strip_look.h"

namespace ridgeline::reconstruct {

/// A radiometry refined by surfaces that both images show. The moments of all flanks
/// (relative_radiometry) also count what one image alone shows, walls above all, and are off by a few
/// hundredths of the range of grey values for it. Here the best candidates of the longest segments
/// that have the same texture on a side, which no gain or offset changes, give the colours of one
/// surface in both images; per band a straight line is fitted to them, robustly. A band without
/// enough of them, or without contrast, keeps its first values.
Radiometry matched_radiometry(const SearchedPair& pair,
                              const Radiometry& first,
                              const CandidateOptions& options,
                              const CandidateLook& change_look = {});

}  // namespace ridgeline::reconstruct
