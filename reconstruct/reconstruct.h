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
  CandidateOptions candidates;  ///< for both matchers
  MatchOptions pairwise;
  ChioOptions chio;
  MatchExtensionOptions beyond;
  ChioExtensionOptions beyond_chio;
  TrackOptions tracks;
};

/// The options of all stages. The defaults are the best-performing settings.
struct Options {
  ExtractionOptions extraction;
  MatchingOptions matching;
  EstimationOptions estimation;
};

/// The options for the papers' methods without our extensions. The votes of the matching still use
/// the appearance of single lines. Our calibrated values are used where the papers give none
/// (weights of the eight constraints, thresholds of the matching, edge detection). Method::kNetwork
/// does not come from a paper.
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
  std::optional<ChioResult> chio;  ///< only if this is the matcher
  /// Segments found during matching, in the base and the search view. Their ids continue those of
  /// the view's segments.
  std::array<std::vector<EdgeSegment>, 2> guided{};
  std::optional<Surface> surface;  ///< empty if no option requires it or the pair has none
};

struct Reconstruction {
  /// In the local frame, as are all lines; with images and segments, including those found during
  /// matching.
  Scene scene;
  std::vector<PairMatches> pairs;  ///< without their surfaces
  std::vector<Track> tracks;
  std::vector<ReconstructedLine> lines;
};

/// Reconstructs 3D lines from oriented images. The steps are: segments of each view, matches of
/// pairs, tracks of all views, lines of the tracks with covariance and status (Ok et al. 2011,
/// sections 2 and 3, and Chio and Wang 2000). The options control the extensions beyond the papers
/// and the method, which is Method::kJoint by default. Programs that store intermediate results
/// call extract(), match_all() and estimate() in this order.
/// @param scene  its views have images and no segments
/// @param pairs  default: pairs_of()
/// The result is the same for any number of threads. Throws std::invalid_argument for fewer than
/// two views, a pair that does not name two different views, options or heights out of range,
/// images of unsupported types or with different numbers of bands, and Method::kPlanes if no pair
/// has a surface.
Reconstruction reconstruct(Scene scene,
                           const Options& options = {},
                           std::span<const ViewPair> pairs = {});

/// Normalises the images of views of the same area and extracts their segments, in all views at a
/// common image size. A view with View::own_segments keeps its segments.
void extract(std::span<View> views, const ExtractionOptions& options = {});

/// The segments of a single view.
std::vector<EdgeSegment> extract(View view, const ExtractionOptions& options = {});

/// The pairs of views to be matched: choose_pairs(), or only the first two views if the options say
/// so.
std::vector<ViewPair> pairs_of(const Scene& scene, const Options& options = {});

/// The matches of a pair of views with segments. The result has its surface, the matches of the
/// chosen matcher and the guided ones (guided_matches()).
PairMatches match(const Scene& scene, const ViewPair& views, const Options& options = {});

/// The surface of a pair that match() uses; empty if no option requires it or the pair has none.
std::optional<Surface> surface_of(const StereoPair& pair, const Options& options = {});

/// Appends the segments found during matching to those of the views. Their ids in the matches
/// continue those of the preceding pairs.
void add_guided(Scene& scene, std::span<PairMatches> pairs);

/// The tracks: the observations of one edge in several views. For a single pair, track i is match
/// i.
/// @param scene  has the segments that the matches refer to; see add_guided()
std::vector<Track> tracks_of(const Scene& scene,
                             std::span<const PairMatches> pairs,
                             const Options& options = {});

/// The matches of several pairs, and the resulting tracks over all views.
struct Matched {
  std::vector<PairMatches> pairs;
  std::vector<Track> tracks;
};

/// match() of each pair, add_guided() and tracks_of().
Matched match_all(Scene& scene, std::span<const ViewPair> pairs, const Options& options = {});

/// A pair whose matches the tracks were formed from.
struct UsedPair {
  ViewPair views;
  const Surface* surface = nullptr;  ///< see surface_of()
};
std::vector<UsedPair> used_pairs(std::span<const PairMatches> pairs);
/// @param surfaces  one per pair; must live as long as the result
std::vector<UsedPair> used_pairs(std::span<const ViewPair> pairs,
                                 std::span<const std::optional<Surface>> surfaces);

/// Estimates the lines of tracks.
/// @param scene  has the segments that the tracks refer to
std::vector<ReconstructedLine> estimate(const Scene& scene,
                                        std::span<const Track> tracks,
                                        std::span<const UsedPair> pairs,
                                        const Options& options = {});

/// Throws std::invalid_argument, which names the first option that is out of range.
void validate(const Options& options);

}  // namespace ridgeline::reconstruct
