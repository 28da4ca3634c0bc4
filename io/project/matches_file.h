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
/// files. Whole or not at all. Throws IoError.
void write_matches(const std::string& path, std::span<const Correspondence> matches);

/// Reads matches.csv; columns in any order, of which left_id and right_id must be there, others are
/// passed over. Throws IoError naming the row for a missing column, an id that is no index or below
/// 0, and for a pair of ids that occurs twice.
std::vector<Correspondence> read_matches(const std::string& path);

/// What a reference file holds: edges, or pairs of segment ids.
using ReferenceMatches = std::variant<std::vector<ReferenceEdge>, std::vector<Correspondence>>;

/// Reads reference matches, told by their header: edges
///   id,kind,left_x1_px,left_y1_px,left_x2_px,left_y2_px,right_x1_px,...,right_y2_px
/// (kind is optional; so is verdict, `correct`, `missed` or, for a wrong pair, `false`: what the
/// review in the report exports), or pairs left_id,right_id of the segments to be judged. Throws
/// IoError naming the row for missing columns, values that are no numbers and other verdicts.
ReferenceMatches read_reference_matches(const std::string& path);

/// Writes reference edges as read_reference_matches() reads them, to thousandths of a pixel. Throws
/// IoError.
void write_reference_edges(const std::string& path, std::span<const ReferenceEdge> edges);

}  // namespace ridgeline::io
