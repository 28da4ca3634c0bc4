// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"
#include "io/lines/straight_vertices.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::io {

/// An empty set for the lines of a file of `n_bytes`. They may take memory of 30 times the file (64
/// MiB at least): far more than the lines of any tool, which state their own ends in digits. Beyond
/// it append_feature() throws IoError, as small files can repeat vertices and attributes endlessly.
LineSet lines_for_file(const std::string& path, const std::string& format, std::size_t n_bytes);

/// Throws IoError if the set has no room for so many lines. It is for readers that hold something
/// for each line before they append it.
void require_room(const LineSet& set, std::size_t n_lines);

/// Adds one feature of a file to the set, with what its columns hold. `fid`: see Line::source_fid;
/// it is the id where `attributes` has none. Vertices on a straight line do not divide it, see
/// bends_of(). A feature with one segment keeps its id; the segments of a longer polyline (or of
/// several parts) are "ID.0", "ID.1", ... with `parent_id` = ID. A part with one vertex is a
/// segment of zero length, a feature without vertices a segment of NaN: both stay in the set, since
/// a line that disappears would flatter its tool.
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
