// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/reconstruct.h"

#include "reconstruct/beyond/combined_matchers/combine_matches.h"
#include "reconstruct/beyond/extensions.h"
#include "reconstruct/beyond/guided_matches/guided_matches.h"
#include "reconstruct/beyond/height_propagation/height_propagation.h"
#include "reconstruct/beyond/profile_registration/profile_registration.h"
#include "reconstruct/beyond/roof_planes/faces_beside.h"
#include "reconstruct/beyond/roof_planes/plane_lines.h"
#include "reconstruct/beyond/shared_errors/shared_errors.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/ok2011/match/connect_matches.h"
#include "reconstruct/ok2011/match/match_pairwise.h"

#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

/// The name of the matcher of those matches that height propagation adds to `pairwise`.
constexpr const char* kByHeight = "pairwise_height";
constexpr const char* kGuided = "guided";

const Surface* address(const std::optional<Surface>& surface) {
  return surface ? &*surface : nullptr;
}

template <typename Outcome>
std::vector<std::string> reasons_of(const std::vector<Outcome>& outcomes) {
  return transformed(outcomes, [](Outcome outcome) { return std::string(name(outcome)); });
}

std::vector<FoundMatch> found_by(Matcher matcher, const std::vector<ScoredMatch>& matches) {
  return transformed(matches, [&](const ScoredMatch& m) { return FoundMatch{m, name(matcher)}; });
}

ChioExtensions chio_extensions(const MatchingOptions& options) {
  return chio_extensions(options.beyond_chio,
                         match_extensions(options.beyond, options.candidates).look);
}

/// Beyond the papers: adds the matches that the heights of matched lines make possible to the list.
void add_by_height(const StereoPair& pair, const MatchingOptions& options, MatchList& list) {
  for (const ScoredMatch& scored :
       propagate_heights(pair, transformed(list.matches, &FoundMatch::scored), options.chio,
                         options.candidates, chio_extensions(options), options.beyond)) {
    list.matches.push_back({scored, kByHeight});
    list.reasons[static_cast<std::size_t>(scored.match.left)] = "matched";
  }
  std::ranges::sort(list.matches, {}, [](const FoundMatch& found) { return found.scored.match; });
}

MatchList by_pairs(const StereoPair& pair,
                   const MatchingOptions& options,
                   const std::optional<Surface>& surface) {
  const MatchResult found =
      match_pairwise(pair, options.pairwise, options.candidates,
                     match_extensions(options.beyond, options.candidates, address(surface)));
  MatchList list{name(Matcher::kPairwise), found_by(Matcher::kPairwise, found.matches),
                 reasons_of(found.outcomes)};
  if (options.beyond.propagate_heights) add_by_height(pair, options, list);
  return list;
}

MatchList list_of(const ChioResult& chio) {
  return {name(Matcher::kChio), found_by(Matcher::kChio, matches_of(chio)),
          reasons_of(chio.outcomes)};
}

MatchList combined(const std::vector<EdgeSegment>& left,
                   const MatchList& pairwise,
                   const ChioResult& chio) {
  MatchList both{kBothMatchers, combine_matches(left, pairwise.matches, chio.lines),
                 pairwise.reasons};
  for (const FoundMatch& found : both.matches) {
    both.reasons[static_cast<std::size_t>(found.scored.match.left)] = "matched";
  }
  return both;
}

/// The registration of each match by the profiles across its edges, as the options say; empty if they ask for
/// none.
std::vector<Registration> registrations_of(const StereoPair& pair,
                                           std::span<const LineMatch> matches,
                                           const EstimationOptions& options) {
  const EstimateExtensionOptions& beyond = options.beyond;
  if (!beyond.register_profiles && !beyond.shared_errors) return {};
  return transformed(compare_profiles(pair, matches, options.lines.max_aligned_angle_deg),
                     [&](const ComparedProfiles& both) {
                       Registration r;
                       if (beyond.register_profiles) r.right_shift_px = both.right_shift_px;
                       if (beyond.shared_errors && both.similarity)
                         r.sigma_scale = own_sigma_scale(*both.similarity);
                       return r;
                     });
}

/// Beyond the papers: looks for the mates of segments without one where the surface predicts them.
void guide(const StereoPair& pair, const Options& options, PairMatches& matches) {
  const MatchExtensionOptions& beyond = options.matching.beyond;
  if (!beyond.guided || !matches.surface) return;
  MatchList& list = matches.lists.back();
  GuidedMatches found = guided_matches(
      pair, *matches.surface, line_matches(list),
      {options.extraction.edges, options.matching.candidates, beyond.guided_min_similarity},
      match_extensions(beyond, options.matching.candidates).look);
  list.reasons.resize(pair.views[0]->segments.size() + found.mates[0].size());
  for (const ScoredMatch& scored : found.matches) {
    list.matches.push_back({scored, kGuided});
    list.reasons[static_cast<std::size_t>(scored.match.left)] = "matched";
  }
  std::ranges::sort(list.matches, {}, [](const FoundMatch& match) { return match.scored.match; });
  matches.guided = std::move(found.mates);
}

/// The lines of matched edges, by every method but Method::kPlanes.
std::vector<ReconstructedLine> lines_of_edges(const StereoPair& pair,
                                              std::span<const LineMatch> matches,
                                              const Options& options,
                                              const Surface* surface) {
  const EstimationOptions& estimation = options.estimation;
  const std::array cameras = pair.cameras();
  const std::array segments{transformed(pair.views[0]->segments, &EdgeSegment::line),
                            transformed(pair.views[1]->segments, &EdgeSegment::line)};
  const std::vector<PairConnection> connections =
      connect_matches(pair, matches, options.matching.pairwise);
  const std::vector<Registration> registrations = registrations_of(pair, matches, estimation);
  std::vector<ReconstructedLine> lines = reconstruct_lines(
      {cameras, segments, matches, connections, registrations, pair.height_range_in_local_m},
      estimation.lines, estimate_extensions(estimation, surface));
  if (estimation.beyond.shared_errors) {
    for (ReconstructedLine& line : lines) add_shared_error(cameras[0], line);
  }
  if (surface != nullptr && estimation.beyond.adjusts_to_faces() &&
      estimation.lines.method != Method::kDirect) {
    const PlaneFaces faces = plane_faces(*surface);
    for (ReconstructedLine& line : lines)
      adjust_to_faces_beside(surface->rectification, faces, line);
  }
  return lines;
}

void check_scene(const Scene& scene, std::span<const ViewPair> pairs) {
  const std::vector<View>& views = scene.views;
  check(views.size() >= 2, "reconstruct: views = ", views.size(), ", must be 2 or more");
  for (const View& view : views) {
    check(is_central_camera(view.image_from_local), "view ", view.id,
          ": the matrix that takes the world to its pixels must be finite and show space");
    check(view.image.channels() == views[0].image.channels(), "view ", view.id,
          ": bands = ", view.image.channels(), ", must be as many as those of view ", views[0].id,
          ", ", views[0].image.channels());
  }
  for (const ViewPair& pair : pairs) {
    check(pair.base != pair.search && std::max(pair.base, pair.search) < views.size(),
          "reconstruct: pair of views ", pair.base, " and ", pair.search,
          ", must be two different ones of ", views.size());
  }
  const auto& [lowest_m, highest_m] = scene.height_range_in_local_m;
  check(std::isfinite(lowest_m) && std::isfinite(highest_m) && lowest_m < highest_m,
        "height_range_m = ", lowest_m, " to ", highest_m,
        ", must be the lowest and the highest height, finite");
}

}  // namespace

const char* name(Matcher matcher) { return matcher == Matcher::kPairwise ? "pairwise" : "chio"; }

std::vector<EdgeSegment> extract(const View& view, const ExtractionOptions& options) {
  return extract_segments(view.image, view.ideal_from_image, options.edges,
                          edge_refinement(options));
}

void extract(Scene& scene, const ExtractionOptions& options) {
  tbb::parallel_for_each(scene.views, [&](View& view) {
    view.image = normalised(view);
    view.segments = extract(view, options);
  });
}

Reconstruction reconstruct(Scene scene, const Options& options, std::span<const ViewPair> pairs) {
  constexpr std::array kFirstTwo{ViewPair{0, 1}};
  if (pairs.empty()) pairs = kFirstTwo;
  check_scene(scene, pairs);
  validate(options);
  Reconstruction result{in_local_frame(std::move(scene)), {}};
  extract(result.scene, options.extraction);
  for (const ViewPair& views_of_pair : pairs) {
    const StereoPair pair = stereo_pair(result.scene, views_of_pair);
    PairMatches matches = match(pair, options);
    check(matches.surface || options.estimation.lines.method != Method::kPlanes,
          "method planes: there is no surface to find planes in; the images cannot be rectified to "
          "each other, or every option that needs it is off");
    const std::array<View, 2> matched = matched_views(pair, matches);
    std::vector<ReconstructedLine> lines =
        estimate({{matched.data(), matched.data() + 1}, pair.height_range_in_local_m},
                 line_matches(matches.used()), options, matches.surface);
    matches.surface.reset();
    result.pairs.push_back({views_of_pair, std::move(matches), std::move(lines)});
  }
  return result;
}

std::optional<Surface> surface_of(const StereoPair& pair, const Options& options) {
  const MatchExtensionOptions& match = options.matching.beyond;
  const EstimateExtensionOptions& estimate = options.estimation.beyond;
  const bool is_taken = match.surface || match.guided ||
                        (estimate.surface && (estimate.consensus || estimate.faces_beside));
  return is_taken ? dense_surface(pair) : std::nullopt;
}

PairMatches match(const StereoPair& pair, const Options& options) {
  const MatchingOptions& matching = options.matching;
  PairMatches result;
  result.surface = surface_of(pair, options);
  for (const Matcher matcher : matching.matchers) {
    if (matcher == Matcher::kPairwise) {
      result.lists.push_back(by_pairs(pair, matching, result.surface));
    } else {
      result.chio = chio_match(pair, matching.chio, matching.candidates, chio_extensions(matching));
      result.lists.push_back(list_of(*result.chio));
    }
  }
  if (result.lists.size() == 2) {
    result.lists.push_back(combined(pair.views[0]->segments, result.lists[0], *result.chio));
  }
  guide(pair, options, result);
  return result;
}

std::array<View, 2> matched_views(const StereoPair& pair, const PairMatches& matches) {
  std::array<View, 2> views{*pair.views[0], *pair.views[1]};
  for (std::size_t v = 0; v < views.size(); ++v) {
    std::ranges::copy(matches.guided[v], std::back_inserter(views[v].segments));
  }
  return views;
}

std::vector<ReconstructedLine> estimate(const StereoPair& pair,
                                        std::span<const LineMatch> matches,
                                        const Options& options,
                                        const std::optional<Surface>& surface) {
  if (options.estimation.lines.method != Method::kPlanes)
    return lines_of_edges(pair, matches, options, address(surface));
  if (!surface) return {};
  Options from_edges = options;
  from_edges.estimation.lines.method = Method::kJoint;
  return plane_lines(pair, *surface, lines_of_edges(pair, matches, from_edges, &*surface),
                     options.estimation.lines.max_aligned_angle_deg);
}

std::vector<LineMatch> line_matches(const MatchList& list) {
  return transformed(list.matches, [](const FoundMatch& found) { return found.scored.match; });
}

Options published() {
  Options options;
  options.extraction.beyond = EdgeExtensionOptions::none();
  options.matching.beyond = MatchExtensionOptions::none();
  options.matching.beyond_chio = ChioExtensionOptions::none();
  options.estimation.beyond = EstimateExtensionOptions::none();
  return options;
}

void validate(const Options& options) {
  check(!options.matching.matchers.empty(), "matchers: none; must be pairwise, chio or both");
  const auto each = [](const auto&... parts) { (ridgeline::validate(parts), ...); };
  each(options.extraction.edges, options.extraction.beyond, options.matching.candidates,
       options.matching.pairwise, options.matching.chio, options.matching.beyond,
       options.matching.beyond_chio, options.estimation.lines, options.estimation.beyond,
       options.estimation.building, options.estimation.consensus);
}

}  // namespace ridgeline::reconstruct
