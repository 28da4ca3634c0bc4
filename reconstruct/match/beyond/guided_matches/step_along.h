// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/image_sampler.h"
#include "reconstruct/extract/ok2011/line_tracer.h"
#include "reconstruct/geometry/segment.h"

#include <optional>

namespace ridgeline::reconstruct {

/// The colour step near an expected line. The gradient across the line is averaged along it. This
/// reveals a step that is too weak in single pixels or lies two pixels beside a stronger one. A
/// peak of the mean within 2 px is a step if it is significant: 3.5 standard deviations, estimated
/// from the scatter along the line. The most significant one, weighted down by its distance from
/// the line (standard deviation 0.5 px), is taken and followed with a window of 5 px.
/// @param expected  in pixels of the file; the result has the same direction
/// Empty if there is no step, if less than three quarters of the line follow it, or if the line is
/// shorter than 10 px.
std::optional<EdgeTrace> step_along(const ImageSampler& image, const Segment2& expected);

}  // namespace ridgeline::reconstruct
