// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "reconstruct/scene/scene.h"

#include <span>

namespace ridgeline::apps {

/// The lines of a scene in the form in which they are written to a file: in the CRS, with class,
/// status, covariance and the image segments from which they were reconstructed. The id is the
/// number of the track, the same for all methods; "17.1", "17.2", ... for the parts of track 17 if
/// it shows several lines; "p0", "p1", ... for lines without a visible edge. A line without
/// geometry is kept, with non-finite coordinates.
io::LineSet line_set_of(std::span<const reconstruct::ReconstructedLine> lines,
                        const reconstruct::Scene& scene,
                        const io::Crs& crs,
                        reconstruct::Method method,
                        double max_aligned_angle_deg);

}  // namespace ridgeline::apps
