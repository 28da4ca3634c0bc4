// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/common/patch_views.h"
#include "io/matches_file.h"
#include "reconstruct/chio/chio_match.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::apps {

enum class Matcher : std::uint8_t { kPairwise, kChio };
const char* name(Matcher matcher);  ///< "pairwise" | "chio"

/// The name of the list that combines both.
inline constexpr const char* kBothMatchers = "both";

struct MatchingOptions {
  std::vector<Matcher> matchers{Matcher::kPairwise};  ///< each once
  reconstruct::MatchOptions pairwise;
  reconstruct::ChioOptions chio;
  /// Lines that `pairwise` left unmatched may take the height of matched neighbours
  /// (reconstruct::propagate_heights()).
  bool propagate_heights = true;
  /// They must look more alike than lines that pairs of segments support (chio.min_similarity): on
  /// the training villages 4 of 19 below this were false, of 6 from here on none.
  double propagate_min_similarity = 0.82;
};

/// `--matcher`: one or both, separated by a comma; `--propagate-heights`.
void add_matcher_options(CLI::App& app, std::vector<std::string>& names, MatchingOptions& options);
/// In the order of the enum, each once; CLI::IsMember has checked the names.
std::vector<Matcher> matchers_named(const std::vector<std::string>& names);
/// Throws std::invalid_argument for values out of range.
void validate_matching(const MatchingOptions& options);

/// What one matcher, or both together, made of a pair.
struct MatchList {
  std::string name;                  ///< "pairwise", "chio" or "both"
  std::vector<io::MatchRow> rows;    ///< by left, then by right index
  std::vector<std::string> reasons;  ///< per left segment; "matched" or why not
};

struct PatchMatches {
  std::vector<MatchList> lists;  ///< one per matcher, then that of both if there are two
  std::optional<reconstruct::ChioResult> chio;

  /// The list that lines are reconstructed from.
  [[nodiscard]] const MatchList& used() const { return lists.back(); }
};

/// The matches of a pair by each matcher, and of both together: all of `pairwise`, and those of `chio`
/// for the segments that it left unmatched.
PatchMatches match_views(const reconstruct::MatchView& left,
                         const reconstruct::MatchView& right,
                         const std::array<double, 2>& height_range_in_local_m,
                         const MatchingOptions& options);

/// The same of a patch.
PatchMatches match_patch(const io::PatchFile& patch,
                         const std::array<cv::Mat, 2>& images,
                         const std::array<std::vector<EdgeSegment>, 2>& segments,
                         const MatchingOptions& options);

/// unmatched.csv: left_id,reason.
std::string unmatched_csv(const MatchList& list);

/// chio.csv: a row for each line of `chio` with its provenance, coordinates of the map:
///   left_id, right_id               the initial link
///   linked_right_ids                further fragments of the right edge, separated by blanks
///   process                         1 to 4
///   neighbour_left_id, neighbour_height_m, height_limit_m   what constrained it; empty in process 1
///   n_pieces, mean_rate, rate_sigma, azimuth_deg, mean_height_m, height_sigma_m   of its edge pieces
///   start_x_m ... end_z_m, sigma_start_x_m ... sigma_end_z_m   the 3D line; empty without one
std::string chio_csv(const reconstruct::ChioResult& result, const LocalFrame& frame);

}  // namespace ridgeline::apps
