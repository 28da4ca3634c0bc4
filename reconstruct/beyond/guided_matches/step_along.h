// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "reconstruct/ok2011/extract/line_tracer.h"
#include "reconstruct/views/image_sampler.h"

#include <optional>

namespace ridgeline::reconstruct {

/// The step of colour beside an expected line, integrated along it: what is too weak to be seen pixel by pixel, or lies
/// two pixels beside a stronger step, shows so. The mean gradient across the line has a peak at each step. That one is
/// taken that is nearest to the line for its significance: mean over scatter along the line, three standard deviations at
/// least and within a pixel or so. Along the line the step is then followed with a window of 5 px.
/// @param expected  in pixels of the file; the result is of the same direction
/// Nothing without a step, where less than three quarters of the line follow it, and for lines shorter than 10 px.
std::optional<EdgeTrace> step_along(const ImageSampler& image, const Segment2& expected);

}  // namespace ridgeline::reconstruct
