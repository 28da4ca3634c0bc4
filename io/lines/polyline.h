// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"

#include <Eigen/Core>

#include <vector>

namespace ridgeline::io {

/// Vertices of one connected line, in the file's CRS.
using Vertices = std::vector<Eigen::Vector3d>;

/// Adds one feature of a file to the set: an empty `attributes.id` becomes `number`, the feature's
/// place in the file from 0. A feature with one segment keeps its id; the segments of a longer
/// polyline (or of several parts) are "ID.0", "ID.1", ... with `parent_id` = ID. A part with one
/// vertex is a segment of zero length, a feature without vertices a segment of NaN: both stay in
/// the set, since a line that disappears would flatter its tool.
void append_feature(const Line& attributes,
                    const std::vector<Vertices>& parts,
                    std::size_t number,
                    LineSet& set);

/// The feature with the one segment.
void append_segment(const Line& attributes,
                    const Segment3& segment_in_world,
                    std::size_t number,
                    LineSet& set);

}  // namespace ridgeline::io
