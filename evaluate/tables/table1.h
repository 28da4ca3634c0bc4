// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/statistics/matching_quality.h"
#include "evaluate/statistics/track_counts.h"

#include <string>
#include <string_view>
#include <vector>

namespace ridgeline::evaluate {

struct Table1Row {
  std::string patch, matcher;
  MatchCounts counts;
  /// Matches that the reference cannot judge (texture, shadows). No figure of the table includes
  /// them.
  std::size_t n_unjudged = 0;
};

/// The comparison of a patch's tracks with its true tracks; see score_tracks().
struct PatchTracks {
  std::string patch;
  std::vector<TrackCell> cells;
  std::size_t n_unjudged = 0;  ///< observations that the reference cannot judge
};

/// Quality of line matching (Ok et al. 2011, Table 1), by number of matches, and of the tracks over
/// several images.
struct Table1 {
  std::vector<Table1Row> rows;
  std::vector<PatchTracks> tracks = {};  ///< of patches with reference tracks
};

/// A table with the shares in percent with one decimal and their Wilson intervals.
std::string to_markdown(const Table1& table);

/// `patch,matcher,correct,false,missed,correctness,completeness,quality`; the last three are ratios
/// with three decimals, empty for a denominator of 0.
std::string to_csv(const Table1& table);

/// `patch,class,n_images,edges,edges_found,edge_recall,shown,shown_found,observation_recall,right,
/// wrong,observation_precision`, a row per class and number of images (`all`, 2, 3, 4, `5 and
/// more`) that has edges.
std::string to_tracks_csv(const Table1& table);

/// {"rows": [{patch, matcher, correct, false, missed, correctness, correctness_ci95, ...}]}, and
/// with reference tracks "tracks": [{patch, unjudged, cells: [{class, n_images (2 to 5, null: all),
/// edges, ...}]}].
std::string to_json(const Table1& table);

/// Reads the counts from the output of to_json(); the figures are computed from them.
/// Throws std::invalid_argument for any other text.
Table1 parse_table1(std::string_view json);

}  // namespace ridgeline::evaluate
