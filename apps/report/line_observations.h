// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/line_views.h"
#include "apps/report/report_input.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ridgeline::apps {

/// A segment that an image of the patch shows of a line.
struct LineInImage {
  std::size_t view = 0;
  std::optional<int> segment;  ///< its number in the image's segment file, if that is known
  std::optional<Segment2> px;  ///< as the line was made from it, ideal pixels
};

/// What a line states of its image segments, in its order. Images that the patch does not have are
/// passed over.
std::vector<LineInImage> observations_of(const ReportPatch& patch, const io::Line& line);

/// What one image shows of a line.
struct LineInView {
  ViewOfLine state = ViewOfLine::kOutside;
  std::optional<Offset> offset;
};

/// What each image of a patch shows of each line of a method, by line and image; empty for patches
/// of two images or without images. Lines that are not known have none.
std::vector<std::vector<LineInView>> lines_in_views(const ReportPatch& patch,
                                                    const ReportMethod& method);

}  // namespace ridgeline::apps
