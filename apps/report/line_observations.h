// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/line_views.h"
#include "apps/report/report_input.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ridgeline::apps {

/// A segment in one of the patch's images that shows a line.
struct LineInImage {
  std::size_t view = 0;
  std::optional<int> segment;  ///< its number in the image's segment file, if known
  std::optional<Segment2> px;  ///< as used to reconstruct the line, ideal pixels
};

/// The image segments that the line lists, in their order. Images that are not in the patch are
/// skipped.
std::vector<LineInImage> observations_of(const ReportPatch& patch, const io::Line& line);

/// How a line appears in one image.
struct LineInView {
  ViewOfLine state = ViewOfLine::kOutside;
  std::optional<Offset> offset;
};

/// How each line of a method appears in each image of a patch, indexed by line and image; empty for
/// patches without images or with only two. Lines that could not be read have no entries.
std::vector<std::vector<LineInView>> lines_in_views(const ReportPatch& patch,
                                                    const ReportMethod& method);

}  // namespace ridgeline::apps
