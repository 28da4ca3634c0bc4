// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/correspondence.h"
#include "reconstruct/geometry/segment.h"

#include <span>
#include <string>
#include <variant>
#include <vector>

namespace ridgeline::io {

/// Writes `left_id,right_id,score,votes,matcher`, one row per match; ids are indices of the segment
/// files. The file is written completely or not at all. Throws IoError if it cannot be written.
void write_matches(const std::string& path, std::span<const Correspondence> matches);

/// Reads matches.csv; columns may be in any order, left_id and right_id are required, unknown
/// columns are ignored. Throws IoError naming the row for a missing column, an id that is not an
/// index (0, 1, ...), and a duplicate pair of ids.
std::vector<Correspondence> read_matches(const std::string& path);

/// The content of a reference file: edges, or pairs of segment ids.
using ReferenceMatches = std::variant<std::vector<ReferenceEdge>, std::vector<Correspondence>>;

/// Reads reference matches; the header determines their form: edges
///   id,kind,left_x1_px,left_y1_px,left_x2_px,left_y2_px,right_x1_px,...,right_y2_px
/// (kind is optional; so is verdict, which the review in the report exports: `correct`, `missed`
/// or, for a wrong pair, `false`), or pairs left_id,right_id of the segments to be judged. Throws
/// IoError naming the row for missing columns, values that are not numbers and other verdicts.
ReferenceMatches read_reference_matches(const std::string& path);

/// Writes reference edges in the form that read_reference_matches() reads, to thousandths of a
/// pixel. Throws IoError if the file cannot be written.
void write_reference_edges(const std::string& path, std::span<const ReferenceEdge> edges);

}  // namespace ridgeline::io
