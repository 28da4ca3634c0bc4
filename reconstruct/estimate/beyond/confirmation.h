// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "reconstruct/scene/scene.h"
#include "reconstruct/surface/surface.h"

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Whether a view should show a line: it lies within the image, and no surface hides more than half
/// of it. A point is hidden if the ray from it to the camera passes below a surface.
bool is_expected(const Scene& scene,
                 std::size_t view,
                 const Segment3& line_in_local,
                 std::span<const Surface* const> surfaces);

/// Marks lines of two views as unconfirmed if a further view should show them but does not. Among
/// lines seen in only two views, those that a third one should show are wrong ten times as often as
/// the others.
void mark_unconfirmed(const Scene& scene,
                      std::span<const Surface* const> surfaces,
                      std::vector<ReconstructedLine>& lines);

}  // namespace ridgeline::reconstruct
