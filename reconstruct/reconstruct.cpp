// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/reconstruct.h"

#include "reconstruct/estimate/beyond/confirmation.h"
#include "reconstruct/estimate/beyond/extensions.h"
#include "reconstruct/estimate/beyond/roof_planes/faces_beside.h"
#include "reconstruct/estimate/beyond/roof_planes/plane_lines.h"
#include "reconstruct/estimate/beyond/shared_errors.h"
#include "reconstruct/estimate/tracked_lines.h"
#include "reconstruct/extract/beyond/extensions.h"
#include "reconstruct/extract/beyond/soft_edges/soft_edges.h"
#include "reconstruct/extract/edges_of_no_data.h"
#include "reconstruct/extract/own_segments.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/match/beyond/extensions.h"
#include "reconstruct/match/beyond/guided_matches/guided_matches.h"
#include "reconstruct/match/ok2011/connect_matches.h"
#include "reconstruct/match/ok2011/match_pairwise.h"
#include "reconstruct/registrations.h"
#include "reconstruct/scaled_scene.h"
#include "reconstruct/scene/reduced_view.h"
#include "reconstruct/tracks/tracks.h"
#include "reconstruct/tracks/view_pairs.h"

#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

/// The matcher name of guided matches.
constexpr const char* kGuided = "guided";

const Surface* address(const std::optional<Surface>& surface) {
  return surface ? &*surface : nullptr;
}

SurfaceOf surfaces_of(std::span<const UsedPair> pairs) {
  return [pairs](std::size_t base, std::size_t search) -> const Surface* {
    const auto is_asked = [&](const UsedPair& pair) {
      return pair.views.base == base && pair.views.search == search;
    };
    const auto found = std::ranges::find_if(pairs, is_asked);
    return found == pairs.end() ? nullptr : found->surface;
  };
}

template <typename Outcome>
std::vector<std::string> reasons_of(const std::vector<Outcome>& outcomes) {
  return transformed(outcomes, [](Outcome outcome) { return std::string(name(outcome)); });
}

std::vector<Correspondence> found_by(const char* matcher, std::vector<Correspondence> matches) {
  for (Correspondence& match : matches) match.matcher = matcher;
  return matches;
}

/// Adds matches of a matcher to the list, for segments without a match.
void add_found(const char* matcher, const std::vector<Correspondence>& matches, MatchList& list) {
  for (const Correspondence& match : found_by(matcher, matches)) {
    list.matches.push_back(match);
    list.reasons[static_cast<std::size_t>(match.base)] = "matched";
  }
  std::ranges::sort(list.matches, {}, &Correspondence::segments);
}

ChioExtensions chio_extensions(const MatchingOptions& options) {
  return chio_extensions(options.beyond_chio,
                         match_extensions(options.beyond, options.candidates).appearance);
}

MatchList by_pairs(const StereoPair& pair,
                   const MatchingOptions& options,
                   const std::optional<Surface>& surface) {
  const MatchResult found =
      match_pairwise(pair, options.pairwise, options.candidates,
                     match_extensions(options.beyond, options.candidates, address(surface)));
  return {found_by(name(Matcher::kPairwise), found.matches), reasons_of(found.outcomes)};
}

MatchList list_of(const ChioResult& chio) {
  return {found_by(name(Matcher::kChio), matches_of(chio)), reasons_of(chio.outcomes)};
}

/// The connections of tracks that both views of a pair show.
std::vector<PairConnection> connections_of(const Scene& scene,
                                           std::span<const Track> tracks,
                                           std::span<const UsedPair> pairs) {
  std::vector<PairConnection> all;
  for (const UsedPair& pair : pairs) {
    std::vector<Correspondence> matches;
    std::vector<int> track_of_match;
    for (std::size_t t = 0; t < tracks.size(); ++t) {
      const auto in_view = [&](std::size_t view) {
        return std::ranges::find(tracks[t].observations, view, &Observation::view);
      };
      const auto base = in_view(pair.views.base);
      const auto search = in_view(pair.views.search);
      if (base == tracks[t].observations.end() || search == tracks[t].observations.end()) continue;
      matches.push_back({base->segment, search->segment});
      track_of_match.push_back(static_cast<int>(t));
    }
    for (const PairConnection& c : connect_matches(stereo_pair(scene, pair.views), matches)) {
      all.push_back({track_of_match[static_cast<std::size_t>(c.i)],
                     track_of_match[static_cast<std::size_t>(c.k)]});
    }
  }
  return all;
}

/// Beyond the papers: searches for the counterparts of unmatched segments where the surface
/// predicts them.
void guide(const StereoPair& pair, const Options& options, PairMatches& matches) {
  const MatchExtensionOptions& beyond = options.matching.beyond;
  if (!beyond.guided || !matches.surface) return;
  MatchList& list = matches.list;
  GuidedMatches found = guided_matches(
      pair, *matches.surface, list.matches, {options.extraction.edges, options.matching.candidates},
      match_extensions(beyond, options.matching.candidates).appearance);
  list.reasons.resize(pair.views[0]->segments.size() + found.counterparts[0].size());
  add_found(kGuided, found.matches, list);
  matches.guided = std::move(found.counterparts);
}

/// Adjusts each line to the faces beside it, as given by the pair of its first two observations.
void adjust_to_faces(std::span<const UsedPair> pairs, std::vector<ReconstructedLine>& lines) {
  std::map<const Surface*, PlaneFaces> faces;
  for (const UsedPair& pair : pairs) {
    if (pair.surface != nullptr) faces[pair.surface] = plane_faces(*pair.surface);
  }
  const SurfaceOf surface_of = surfaces_of(pairs);
  for (ReconstructedLine& line : lines) {
    const Surface* surface = surface_of(line.base().view, line.other().view);
    if (surface != nullptr) adjust_to_faces_beside(surface->rectification, faces.at(surface), line);
  }
}

/// The lines of matched edges, by a method that works on tracks.
std::vector<ReconstructedLine> lines_of_edges(const Scene& scene,
                                              std::span<const Track> tracks,
                                              std::span<const UsedPair> pairs,
                                              const Options& options) {
  const EstimationOptions& estimation = options.estimation;
  const auto cameras = transformed(scene.views, &View::image_from_local);
  const auto segments = transformed(
      scene.views, [](const View& view) { return transformed(view.segments, &EdgeSegment::line); });
  const std::vector<PairConnection> connections = connections_of(scene, tracks, pairs);
  TrackedSegments tracked{.cameras = cameras,
                          .segments = segments,
                          .tracks = tracks,
                          .connections = connections,
                          .height_range_in_local_m = scene.height_range_in_local_m};
  const std::vector<Registrations> registrations = registrations_of(scene, tracked, estimation);
  tracked.registrations = registrations;
  std::vector<ReconstructedLine> lines = reconstruct_lines(
      tracked, estimation.lines, estimate_extensions(estimation, surfaces_of(pairs)));
  if (estimation.beyond.shared_errors) {
    for (ReconstructedLine& line : lines) add_shared_error(cameras[line.base().view], line);
  }
  if (estimation.beyond.adjusts_to_faces() && estimation.lines.method != Method::kDirect)
    adjust_to_faces(pairs, lines);
  if (pairs.size() > 1) {
    std::vector<const Surface*> surfaces;
    for (const UsedPair& pair : pairs) {
      if (pair.surface != nullptr) surfaces.push_back(pair.surface);
    }
    mark_unconfirmed(scene, surfaces, lines);
  }
  return lines;
}

void check_scene(const Scene& scene, std::span<const ViewPair> pairs) {
  const std::vector<View>& views = scene.views;
  check(views.size() >= 2, "reconstruct: views = ", views.size(), ", must be 2 or more");
  for (const View& view : views) {
    check(is_central_camera(view.image_from_local), "view ", view.id,
          ": its projection matrix must be finite and of full rank");
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

void extract(std::span<View> views, const ExtractionOptions& options) {
  const auto extract_smoothed = [&](const View& seen, double gradient_sigma_px) {
    const ImagePart image(seen.image, {seen.corner_px.x(), seen.corner_px.y()},
                          far_from_no_data(seen.is_valid));
    ExtractionOptions smoothed = options;
    smoothed.edges.gradient_sigma_px = gradient_sigma_px;
    const EdgeRefinement refine = [&, beyond = edge_refinement(smoothed)](
                                      std::vector<EdgeTrace> edges, const ImagePart& part) {
      return edges_on_data(beyond(std::move(edges), part), part.has_data,
                           smoothed.edges.min_length_px);
    };
    return extract_segments(image, seen.ideal_from_image, smoothed.edges, refine);
  };
  const double gradient_sigma_px = options.edges.gradient_sigma_px;
  tbb::parallel_for_each(views, [&](View& view) {
    view.image = normalised(view);
    if (view.own_segments) {
      view.segments = completed_own_segments(view);
    } else if (!options.beyond.soft_edges) {
      view.segments = extract_smoothed(view, gradient_sigma_px);
    }
  });
  if (!options.beyond.soft_edges) return;
  std::vector<View*> searched;
  for (View& view : views) {
    if (!view.own_segments) searched.push_back(&view);
  }
  auto found = segments_at_common_size(std::vector<const View*>(searched.begin(), searched.end()),
                                       gradient_sigma_px, extract_smoothed);
  for (std::size_t i = 0; i < searched.size(); ++i) searched[i]->segments = std::move(found[i]);
}

std::vector<EdgeSegment> extract(View view, const ExtractionOptions& options) {
  extract({&view, 1}, options);
  return std::move(view.segments);
}

Reconstruction reconstruct(Scene scene, const Options& options, std::span<const ViewPair> pairs) {
  check_scene(scene, pairs);
  validate(options);
  Reconstruction result{in_local_frame(std::move(scene)), {}, {}, {}};
  extract(result.scene.views, options.extraction);
  const std::vector<ViewPair> used =
      pairs.empty() ? pairs_of(result.scene, options) : std::vector(pairs.begin(), pairs.end());
  Matched matched = match_all(result.scene, used, options);
  result.pairs = std::move(matched.pairs);
  result.tracks = std::move(matched.tracks);
  check(options.estimation.lines.method != Method::kPlanes ||
            std::ranges::any_of(result.pairs, [](const auto& p) { return p.surface.has_value(); }),
        "method planes: there is no surface to find planes in; the images cannot be rectified to "
        "each other, or every option that uses it is off");
  result.lines = estimate(result.scene, result.tracks, used_pairs(result.pairs), options);
  for (PairMatches& pair : result.pairs) pair.surface.reset();
  return result;
}

std::vector<ViewPair> pairs_of(const Scene& scene, const Options& options) {
  if (!options.matching.tracks.all_views) return {{0, 1}};
  return choose_pairs(scene);
}

namespace {

bool takes_surface(const Options& options) {
  const MatchExtensionOptions& match = options.matching.beyond;
  const EstimateExtensionOptions& estimate = options.estimation.beyond;
  return match.surface || match.guided ||
         (estimate.surface && (estimate.consensus || estimate.faces_beside));
}

}  // namespace

std::optional<Surface> surface_of(const StereoPair& pair, const Options& options) {
  if (!takes_surface(options)) return std::nullopt;
  const ScaledPair scaled(pair);
  std::optional<Surface> surface = dense_surface(scaled.pair());
  if (surface) take_to_pixels_of_files(pair, *surface);
  return surface;
}

PairMatches match(const Scene& scene, const ViewPair& views, const Options& options) {
  const MatchingOptions& matching = options.matching;
  const StereoPair in_files = stereo_pair(scene, views);
  const ScaledPair scaled(in_files);
  const StereoPair pair = scaled.pair();
  PairMatches result;
  result.views = views;
  if (takes_surface(options)) result.surface = dense_surface(pair);
  if (matching.matcher == Matcher::kPairwise) {
    result.list = by_pairs(pair, matching, result.surface);
  } else {
    result.chio = chio_match(pair, matching.chio, matching.candidates, chio_extensions(matching));
    result.list = list_of(*result.chio);
  }
  guide(pair, options, result);
  for (const std::size_t side : {0U, 1U}) {
    const View& view = *in_files.views[side];
    result.guided[side] = in_pixels_of(view, scale_of_edges(view), std::move(result.guided[side]));
  }
  if (result.surface) take_to_pixels_of_files(in_files, *result.surface);
  return result;
}

void add_guided(Scene& scene, std::span<PairMatches> pairs) {
  const std::vector<std::size_t> n_extracted =
      transformed(scene.views, [](const View& view) { return view.segments.size(); });
  for (PairMatches& pair : pairs) {
    const std::array of_pair{pair.views.base, pair.views.search};
    const auto renumber = [&](std::size_t side, int& id) {
      const std::size_t n = n_extracted[of_pair[side]];
      if (static_cast<std::size_t>(id) >= n)
        id += static_cast<int>(scene.views[of_pair[side]].segments.size() - n);
    };
    for (Correspondence& found : pair.list.matches) {
      renumber(0, found.base);
      renumber(1, found.other);
    }
    for (const std::size_t side : {0U, 1U})
      std::ranges::copy(pair.guided[side], std::back_inserter(scene.views[of_pair[side]].segments));
  }
}

std::vector<Track> tracks_of(const Scene& scene,
                             std::span<const PairMatches> pairs,
                             const Options& options) {
  if (pairs.size() == 1) return tracks_of_pair(pairs[0].views, pairs[0].list.matches);
  const auto matched = transformed(pairs, [](const PairMatches& pair) {
    return MatchedPair{pair.views, pair.list.matches};
  });
  return tracks_of(at_scale_of_edges(scene), matched, options.matching.candidates,
                   options.matching.tracks);
}

Matched match_all(Scene& scene, std::span<const ViewPair> pairs, const Options& options) {
  Matched matched;
  for (const ViewPair& views : pairs) matched.pairs.push_back(match(scene, views, options));
  add_guided(scene, matched.pairs);
  matched.tracks = tracks_of(scene, matched.pairs, options);
  return matched;
}

std::vector<UsedPair> used_pairs(std::span<const PairMatches> pairs) {
  return transformed(pairs, [](const PairMatches& pair) {
    return UsedPair{pair.views, address(pair.surface)};
  });
}

std::vector<UsedPair> used_pairs(std::span<const ViewPair> pairs,
                                 std::span<const std::optional<Surface>> surfaces) {
  std::vector<UsedPair> used;
  for (std::size_t i = 0; i < pairs.size(); ++i) used.push_back({pairs[i], address(surfaces[i])});
  return used;
}

namespace {

std::vector<ReconstructedLine> estimate_at_scale(const Scene& scene,
                                                 std::span<const Track> tracks,
                                                 std::span<const UsedPair> pairs,
                                                 const Options& options) {
  const Method method = options.estimation.lines.method;
  if (!has_lines_of_planes(method)) return lines_of_edges(scene, tracks, pairs, options);
  Options from_edges = options;
  from_edges.estimation.lines.method = method == Method::kLines ? Method::kNetwork : Method::kJoint;
  std::vector<ReconstructedLine> lines = lines_of_edges(scene, tracks, pairs, from_edges);
  const auto n_of_edges = static_cast<std::ptrdiff_t>(lines.size());
  for (const UsedPair& pair : pairs) {
    if (pair.surface == nullptr) continue;
    for (ReconstructedLine& line : plane_lines(stereo_pair(scene, pair.views), *pair.surface, lines,
                                               options.estimation.lines.max_aligned_angle_deg)) {
      line.base().view = pair.views.base;
      line.other().view = pair.views.search;
      lines.push_back(std::move(line));
    }
  }
  if (method == Method::kPlanes) lines.erase(lines.begin(), lines.begin() + n_of_edges);
  return lines;
}

}  // namespace

std::vector<ReconstructedLine> estimate(const Scene& scene,
                                        std::span<const Track> tracks,
                                        std::span<const UsedPair> pairs,
                                        const Options& options) {
  std::vector<Surface> surfaces;
  surfaces.reserve(pairs.size());
  const std::vector<int> factors = transformed(
      scene.views, options.extraction.beyond.soft_edges ? scale_of_blur : scale_of_edges);
  std::vector<UsedPair> scaled_pairs(pairs.begin(), pairs.end());
  for (UsedPair& pair : scaled_pairs) {
    if (pair.surface == nullptr) continue;
    surfaces.push_back(reduced(stereo_pair(scene, pair.views), *pair.surface,
                               {factors[pair.views.base], factors[pair.views.search]}));
    pair.surface = &surfaces.back();
  }
  std::vector<ReconstructedLine> lines =
      estimate_at_scale(at_scale_of_blur(scene, factors), tracks, scaled_pairs, options);
  for (ReconstructedLine& line : lines) {
    for (ObservedSegment& seen : line.observations) {
      const std::size_t view = seen.view;
      seen.px = in_pixels_of(scene.views[view], factors[view], seen.px);
    }
  }
  return lines;
}

Options published() {
  Options options;
  options.extraction.beyond = EdgeExtensionOptions::none();
  options.matching.beyond = MatchExtensionOptions::none();
  options.matching.beyond_chio = ChioExtensionOptions::none();
  options.matching.tracks.all_views = false;
  options.estimation.beyond = EstimateExtensionOptions::none();
  return options;
}

void validate(const Options& options) {
  const auto each = [](const auto&... parts) { (ridgeline::validate(parts), ...); };
  each(options.extraction.edges, options.extraction.beyond, options.matching.candidates,
       options.matching.pairwise, options.matching.chio, options.matching.beyond,
       options.matching.beyond_chio, options.matching.tracks, options.estimation.lines,
       options.estimation.beyond, options.estimation.building, options.estimation.consensus);
}

}  // namespace ridgeline::reconstruct
