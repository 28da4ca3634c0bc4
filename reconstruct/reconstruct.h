// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/options.h"
#include "reconstruct/beyond/surface/surface.h"
#include "reconstruct/chio_wang2000/chio_match.h"
#include "reconstruct/geometry/local_frame.h"
#include "reconstruct/ok2011/estimate/reconstruct_lines.h"
#include "reconstruct/ok2011/extract/extract_segments.h"
#include "reconstruct/ok2011/match/options.h"
#include "reconstruct/views/match_view.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::reconstruct {

/// An oriented image in memory.
struct View {
  std::string id;
  cv::Mat image;  ///< 8 or 16 bits with 1 to 4 bands, or what normalised_image() made of it
  ProjectionMatrix image_from_world;  ///< pixel (0, 0) is the centre of the top-left one
  PixelMap ideal_from_image;  ///< takes the distortion of the lens away; empty: there is none
};

/// Two of several views, by their numbers.
struct ViewPair {
  std::size_t base = 0, search = 1;
};

enum class Matcher : std::uint8_t { kPairwise, kChio };
const char* name(Matcher matcher);  ///< "pairwise" | "chio"

/// The name of the list that combines both.
inline constexpr const char* kBothMatchers = "both";

struct MatchingOptions {
  std::vector<Matcher> matchers{Matcher::kPairwise};  ///< each once
  CandidateOptions candidates;                        ///< of both
  MatchOptions pairwise;
  ChioOptions chio;
  MatchExtensionOptions beyond;
};

/// The default is the best we know.
struct Options {
  ExtractionOptions extraction;
  MatchingOptions matching;
  EstimationOptions estimation;
};

/// What the papers state without our extensions. The votes of the matching still rest on the look of single lines. Where
/// the papers are silent (weights of the eight constraints, thresholds of
/// the matching, the detection of edges) our calibrated values stand. Method::kNetwork is not of a paper.
Options published();

/// What one matcher, or both together, made of a pair.
struct MatchList {
  std::string name;                  ///< "pairwise", "chio" or "both"
  std::vector<FoundMatch> matches;   ///< by left, then by right index
  std::vector<std::string> reasons;  ///< per left segment; "matched" or why not
};

struct Matches {
  std::vector<MatchList> lists;  ///< one per matcher, then that of both if there are two
  std::optional<ChioResult> chio;

  /// The list that lines are reconstructed from.
  [[nodiscard]] const MatchList& used() const { return lists.back(); }
};

struct PairReconstruction {
  ViewPair views;
  Matches matches;
  std::vector<ReconstructedLine> lines;
  /// Mates that were found while matching, base and search view: their ids go on from the view's segments.
  std::array<std::vector<EdgeSegment>, 2> guided{};
};

struct Reconstruction {
  LocalFrame frame;                                ///< of all lines: world = local + origin
  std::vector<std::vector<EdgeSegment>> segments;  ///< by view
  std::vector<PairReconstruction> pairs;
};

/// 3D lines of oriented images: segments of each view, matches of each pair, lines of each pair with covariance and
/// status. Ok et al. 2011, sections 2 and 3, and Chio and Wang 2000, with what goes beyond them as the options say.
/// The stages below can be called one by one.
/// @param height_range_m  lowest and highest height of objects, world
/// @param pairs           default: the first two views
/// Deterministic for any number of threads. Throws std::invalid_argument for fewer than two views, a pair that names none
/// of them, options or heights out of range, images of other types or different numbers of bands, and Method::kPlanes of
/// a pair without a surface.
Reconstruction reconstruct(std::span<const View> views,
                           const std::array<double, 2>& height_range_m,
                           const Options& options = {},
                           std::span<const ViewPair> pairs = {});

/// The local frame for a base view: the point that its middle shows at the mean height, rounded to 100 m.
LocalFrame local_frame(const ProjectionMatrix& image_from_world,
                       const Eigen::Vector2d& size_px,
                       const std::array<double, 2>& height_range_m);

/// The segments of an image.
/// @param image  as normalised() gives it
std::vector<EdgeSegment> extract(const cv::Mat& image,
                                 const PixelMap& ideal_from_image = {},
                                 const ExtractionOptions& options = {});

/// The view's image as the stages use it.
cv::Mat normalised(const View& view);

/// The surface of a pair for match(), guide() and estimate(); none if no option asks for it or the pair has none.
std::optional<Surface> surface_of(const StereoPair& pair, const Options& options = {});

/// The matches of a pair by each matcher, and of both together: all of `pairwise`, and those of `chio` for the segments
/// that it left unmatched.
Matches match(const StereoPair& pair,
              const MatchingOptions& options = {},
              const std::optional<Surface>& surface = {});

/// Adds what guided_matches() finds: mates to the segments of the pair, matches to the list that is used.
/// Nothing without a surface, or if the options do not ask for it.
void guide(StereoPair& pair,
           Matches& matches,
           const Options& options,
           const std::optional<Surface>& surface);

/// The lines of matched segments.
/// @param pair_options  of the pair connections
std::vector<ReconstructedLine> estimate(const StereoPair& pair,
                                        std::span<const LineMatch> matches,
                                        const EstimationOptions& options = {},
                                        const MatchOptions& pair_options = {},
                                        const std::optional<Surface>& surface = {});

/// The matches of a list without what speaks for them.
std::vector<LineMatch> line_matches(const MatchList& list);

/// Throws std::invalid_argument naming the first option that is out of range.
void validate(const Options& options);

}  // namespace ridgeline::reconstruct
