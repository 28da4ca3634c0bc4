// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"
#include "io/lines/straight_vertices.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::io {

/// An empty set for the lines of a file of `n_bytes`. In memory, they may take 30 times the size of
/// the file (at least 64 MiB): far more than the lines of any tool, whose end points are written
/// out as digits. Beyond that, append_feature() throws IoError, because small files can repeat
/// vertices and attributes endlessly.
LineSet lines_for_file(const std::string& path, const std::string& format, std::size_t n_bytes);

/// Throws IoError if the set has no room for `n_lines` lines. Meant for readers that hold data for
/// each line before they append it.
void require_room(const LineSet& set, std::size_t n_lines);

/// Adds one feature of a file to the set, with the values of its columns. `fid`: see
/// Line::source_fid; it becomes the id if `attributes` has none. Vertices on a straight line do not
/// divide it, see bends_of(). A feature with one segment keeps its id; the segments of a longer
/// polyline (or of several parts) are "ID.0", "ID.1", ... with `parent_id` = ID. A part with one
/// vertex is a segment of zero length, a feature without vertices a segment of NaN: both stay in
/// the set because a line that disappears would flatter its tool.
void append_feature(const Line& attributes,
                    const std::vector<Vertices>& parts,
                    std::int64_t fid,
                    LineSet& set,
                    SparseRow values = {});

/// Adds a feature with one segment, see append_feature(). Its fid is `number`.
void append_segment(const Line& attributes,
                    const Segment3& segment_in_world,
                    std::size_t number,
                    LineSet& set);

}  // namespace ridgeline::io
