// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/options.h"
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "reconstruct/extract/beyond/options.h"
#include "reconstruct/extract/ok2011/extract_segments.h"
#include "reconstruct/match/beyond/options.h"
#include "reconstruct/match/chio_wang2000/chio_match.h"
#include "reconstruct/match/ok2011/options.h"
#include "reconstruct/scene/scene.h"
#include "reconstruct/surface/surface.h"
#include "reconstruct/tracks/options.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::reconstruct {

enum class Matcher : std::uint8_t { kPairwise, kChio };
const char* name(Matcher matcher);  ///< "pairwise" | "chio"

struct MatchingOptions {
  Matcher matcher = Matcher::kPairwise;
  CandidateOptions candidates;  ///< of both matchers
  MatchOptions pairwise;
  ChioOptions chio;
  MatchExtensionOptions beyond;
  ChioExtensionOptions beyond_chio;
  TrackOptions tracks;
};

/// The options of all stages. The defaults are the best we know.
struct Options {
  ExtractionOptions extraction;
  MatchingOptions matching;
  EstimationOptions estimation;
};

/// The options for what the papers state without our extensions. The votes of the matching still
/// rest on the appearance of single lines. Our calibrated values stand where the papers are silent
/// (weights of the eight constraints, thresholds of the matching, the detection of edges).
/// Method::kNetwork is not of a paper.
Options published();

/// The matches of a pair.
struct MatchList {
  std::vector<Correspondence> matches;  ///< in the order of Correspondence::segments()
  std::vector<std::string> reasons;     ///< per left segment: "matched", or why it has no match
};

/// The results of matching a pair.
struct PairMatches {
  ViewPair views;
  MatchList list;
  std::optional<ChioResult> chio;  ///< if this is the matcher
  /// Segments found while matching, in the base and the search view. Their ids go on from those of
  /// the view's segments.
  std::array<std::vector<EdgeSegment>, 2> guided{};
  std::optional<Surface> surface;  ///< none if no option asks for it or the pair has none
};

struct Reconstruction {
  /// In the local frame that all lines are in, with images and segments, those found while matching
  /// too.
  Scene scene;
  std::vector<PairMatches> pairs;  ///< without their surfaces
  std::vector<Track> tracks;
  std::vector<ReconstructedLine> lines;
};

/// 3D lines of oriented images. The steps are: segments of each view, matches of pairs, tracks of
/// all views, lines of the tracks with covariance and status (Ok et al. 2011, sections 2 and 3, and
/// Chio and Wang 2000). What goes beyond the papers is done as the options say; the method is
/// Method::kJoint unless they name another one. Programs that keep files in between call extract(),
/// match_all() and estimate() in this order.
/// @param scene  its views have images and no segments
/// @param pairs  default: pairs_of()
/// The result is the same for any number of threads. Throws std::invalid_argument for fewer than
/// two views, a pair that does not name two different views, options or heights out of range,
/// images of other types or different numbers of bands, and Method::kPlanes for a pair without a
/// surface.
Reconstruction reconstruct(Scene scene,
                           const Options& options = {},
                           std::span<const ViewPair> pairs = {});

/// Normalises the images of the views of one place and finds their segments, those of all views at
/// a common size. A view with View::own_segments keeps these.
void extract(std::span<View> views, const ExtractionOptions& options = {});

/// The segments of a view by itself.
std::vector<EdgeSegment> extract(View view, const ExtractionOptions& options = {});

/// The pairs of views to be matched: choose_pairs(), or the first two views alone if the options
/// say so.
std::vector<ViewPair> pairs_of(const Scene& scene, const Options& options = {});

/// The matches of a pair of views with segments. The result has its surface, the matches of each
/// matcher, those of both together (all of `pairwise`, and those of `chio` for the segments that it
/// left unmatched), and guided ones (guided_matches()).
PairMatches match(const Scene& scene, const ViewPair& views, const Options& options = {});

/// The surface of a pair that match() uses; nothing if no option asks for it or the pair has none.
std::optional<Surface> surface_of(const StereoPair& pair, const Options& options = {});

/// Appends the segments that were found while matching to those of the views. Their ids in the
/// matches go on from those of the pairs before.
void add_guided(Scene& scene, std::span<PairMatches> pairs);

/// What several views show of one edge each. Of a single pair, track i is match i.
/// @param scene  has the segments that the matches refer to; see add_guided()
std::vector<Track> tracks_of(const Scene& scene,
                             std::span<const PairMatches> pairs,
                             const Options& options = {});

/// The matches of several pairs, and the tracks of all views that they give.
struct Matched {
  std::vector<PairMatches> pairs;
  std::vector<Track> tracks;
};

/// match() of each pair, add_guided() and tracks_of().
Matched match_all(Scene& scene, std::span<const ViewPair> pairs, const Options& options = {});

/// A pair whose matches the tracks are made of.
struct UsedPair {
  ViewPair views;
  const Surface* surface = nullptr;  ///< see surface_of()
};
std::vector<UsedPair> used_pairs(std::span<const PairMatches> pairs);
/// @param surfaces  one per pair; must live as long as the result
std::vector<UsedPair> used_pairs(std::span<const ViewPair> pairs,
                                 std::span<const std::optional<Surface>> surfaces);

/// The lines of tracks.
/// @param scene  has the segments that the tracks refer to
std::vector<ReconstructedLine> estimate(const Scene& scene,
                                        std::span<const Track> tracks,
                                        std::span<const UsedPair> pairs,
                                        const Options& options = {});

/// Throws std::invalid_argument naming the first option that is out of range.
void validate(const Options& options);

}  // namespace ridgeline::reconstruct
