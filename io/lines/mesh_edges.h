// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/lines/line_set.h"
#include "io/lines/polyline.h"

#include <cstddef>
#include <vector>

namespace ridgeline::io {

/// Indices from 0 of the vertices of a polygon or a polyline.
using IndexList = std::vector<std::size_t>;

/// Adds each distinct edge of closed polygons once, in the order of first occurrence. Edges are the
/// same if their end points have equal coordinates, in either direction: many models repeat the
/// vertices for each face. Edges of zero length are left out, they bound nothing.
void append_distinct_edges(const Vertices& vertices,
                           const std::vector<IndexList>& polygons,
                           LineSet& set);

}  // namespace ridgeline::io
