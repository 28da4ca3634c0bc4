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
#include "reconstruct/views/normalised_image.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

/// The matcher of what height propagation adds to `pairwise`.
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

/// Beyond the papers: lines that the height of matched ones makes possible join the list.
void add_by_height(const StereoPair& pair, const MatchingOptions& options, MatchList& list) {
  const CandidateLook look = match_extensions(options.beyond, options.candidates).look;
  for (const ScoredMatch& scored :
       propagate_heights(pair, transformed(list.matches, &FoundMatch::scored), options.chio,
                         options.candidates, options.beyond, look)) {
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

/// What the profiles across the edges tell of their places, as the options have it; empty: nothing.
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

void check_views(std::span<const View> views, std::span<const ViewPair> pairs) {
  check(views.size() >= 2, "reconstruct: views = ", views.size(), ", must be 2 or more");
  for (const View& view : views) {
    const ProjectionMatrix& p = view.image_from_world;
    check(p.allFinite() && p.leftCols<3>().fullPivLu().isInvertible(), "view ", view.id,
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
}

}  // namespace

const char* name(Matcher matcher) { return matcher == Matcher::kPairwise ? "pairwise" : "chio"; }

LocalFrame local_frame(const ProjectionMatrix& image_from_world,
                       const Eigen::Vector2d& size_px,
                       const std::array<double, 2>& height_range_m) {
  constexpr double kStep_m = 100.0;
  const double mean_m = 0.5 * (height_range_m[0] + height_range_m[1]);
  const Eigen::Vector3d x =
      point_on_plane(image_from_world, 0.5 * size_px, Plane3(Eigen::Vector3d::UnitZ(), -mean_m));
  return {(x / kStep_m).array().round() * kStep_m};
}

cv::Mat normalised(const View& view) {
  return view.image.depth() == CV_32F ? view.image : normalised_image(view.image);
}

std::vector<EdgeSegment> extract(const cv::Mat& image,
                                 const PixelMap& ideal_from_image,
                                 const ExtractionOptions& options) {
  return extract_segments(image, ideal_from_image, options.edges, edge_refinement(options));
}

Reconstruction reconstruct(std::span<const View> views,
                           const std::array<double, 2>& height_range_m,
                           const Options& options,
                           std::span<const ViewPair> pairs) {
  constexpr std::array kFirstTwo{ViewPair{0, 1}};
  if (pairs.empty()) pairs = kFirstTwo;
  check_views(views, pairs);
  check(std::isfinite(height_range_m[0]) && std::isfinite(height_range_m[1]) &&
            height_range_m[0] < height_range_m[1],
        "height_range_m = ", height_range_m[0], " to ", height_range_m[1],
        ", must be the lowest and the highest height, finite");
  validate(options);
  Reconstruction result;
  const cv::Mat& base = views[0].image;
  result.frame = local_frame(views[0].image_from_world, {base.cols, base.rows}, height_range_m);

  std::vector<cv::Mat> images(views.size());
  result.segments.resize(views.size());
  tbb::parallel_for(std::size_t{0}, views.size(), [&](std::size_t v) {
    images[v] = normalised(views[v]);
    result.segments[v] = extract(images[v], views[v].ideal_from_image, options.extraction);
  });

  const auto matched_view = [&](std::size_t v) -> MatchView {
    return {image_from_local(views[v].image_from_world, result.frame.origin_m), images[v],
            result.segments[v], views[v].ideal_from_image};
  };
  const double origin_m = result.frame.origin_m.z();
  for (const ViewPair& views_of_pair : pairs) {
    StereoPair pair{{matched_view(views_of_pair.base), matched_view(views_of_pair.search)},
                    {height_range_m[0] - origin_m, height_range_m[1] - origin_m}};
    const std::optional<Surface> surface = surface_of(pair, options);
    check(surface || options.estimation.lines.method != Method::kPlanes,
          "method planes: there is no surface to find planes in; the images cannot be rectified to "
          "each other, or "
          "every option that needs it is off");
    Matches matches = match(pair, options.matching, surface);
    guide(pair, matches, options, surface);
    std::vector<ReconstructedLine> lines = estimate(
        pair, line_matches(matches.used()), options.estimation, options.matching.pairwise, surface);
    const auto guided = [&](std::size_t j, std::size_t v) {
      const std::vector<EdgeSegment>& all = pair.views[j].segments;
      const auto extracted = static_cast<std::ptrdiff_t>(result.segments[v].size());
      return std::vector(all.begin() + extracted, all.end());
    };
    result.pairs.push_back({views_of_pair,
                            std::move(matches),
                            std::move(lines),
                            {guided(0, views_of_pair.base), guided(1, views_of_pair.search)}});
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

Matches match(const StereoPair& pair,
              const MatchingOptions& options,
              const std::optional<Surface>& surface) {
  Matches result;
  for (const Matcher matcher : options.matchers) {
    if (matcher == Matcher::kPairwise) {
      result.lists.push_back(by_pairs(pair, options, surface));
    } else {
      result.chio = chio_match(pair, options.chio, options.candidates,
                               match_extensions(options.beyond, options.candidates).look);
      result.lists.push_back(list_of(*result.chio));
    }
  }
  if (result.lists.size() == 2) {
    result.lists.push_back(combined(pair.views[0].segments, result.lists[0], *result.chio));
  }
  return result;
}

std::vector<ReconstructedLine> estimate(const StereoPair& pair,
                                        std::span<const LineMatch> matches,
                                        const EstimationOptions& options,
                                        const MatchOptions& pair_options,
                                        const std::optional<Surface>& surface) {
  if (options.lines.method == Method::kPlanes) {
    if (!surface) return {};
    EstimationOptions from_edges = options;
    from_edges.lines.method = Method::kJoint;
    return plane_lines(pair, *surface, estimate(pair, matches, from_edges, pair_options, surface),
                       options.lines.max_aligned_angle_deg);
  }
  const std::vector<PairConnection> connections = connect_matches(pair, matches, pair_options);
  const std::vector<Registration> registrations = registrations_of(pair, matches, options);
  EstimationOptions within_heights = options;
  within_heights.lines.lowest_height_m = pair.height_range_in_local_m[0];
  within_heights.lines.highest_height_m = pair.height_range_in_local_m[1];
  const std::array geometry{transformed(pair.views[0].segments, &EdgeSegment::line),
                            transformed(pair.views[1].segments, &EdgeSegment::line)};
  std::vector<ReconstructedLine> lines =
      reconstruct_lines(pair.cameras(), geometry, matches, connections, within_heights.lines,
                        registrations, estimate_extensions(within_heights, address(surface)));
  if (options.beyond.shared_errors) {
    for (ReconstructedLine& line : lines) add_shared_error(pair.cameras()[0], line);
  }
  if (surface && options.beyond.adjusts_to_faces() && options.lines.method != Method::kDirect) {
    const PlaneFaces faces = plane_faces(*surface);
    for (ReconstructedLine& line : lines)
      adjust_to_faces_beside(surface->rectification, faces, line);
  }
  return lines;
}

void guide(StereoPair& pair,
           Matches& matches,
           const Options& options,
           const std::optional<Surface>& surface) {
  const MatchExtensionOptions& beyond = options.matching.beyond;
  if (!beyond.guided || !surface) return;
  MatchList& list = matches.lists.back();
  GuidedMatches guided = guided_matches(
      pair, *surface, line_matches(list),
      {options.extraction.edges, options.matching.candidates, beyond.guided_min_similarity},
      match_extensions(beyond, options.matching.candidates).look);
  for (std::size_t v = 0; v < guided.mates.size(); ++v) {
    std::ranges::move(guided.mates[v], std::back_inserter(pair.views[v].segments));
  }
  list.reasons.resize(pair.views[0].segments.size());
  for (const ScoredMatch& scored : guided.matches) {
    list.matches.push_back({scored, kGuided});
    list.reasons[static_cast<std::size_t>(scored.match.left)] = "matched";
  }
  std::ranges::sort(list.matches, {}, [](const FoundMatch& found) { return found.scored.match; });
}

std::vector<LineMatch> line_matches(const MatchList& list) {
  return transformed(list.matches, [](const FoundMatch& found) { return found.scored.match; });
}

Options published() {
  Options options;
  options.extraction.beyond = EdgeExtensionOptions::none();
  options.matching.beyond = MatchExtensionOptions::none();
  options.matching.chio.paper = true;
  options.estimation.beyond = EstimateExtensionOptions::none();
  return options;
}

void validate(const Options& options) {
  check(!options.matching.matchers.empty(), "matchers: none; must be pairwise, chio or both");
  const auto each = [](const auto&... parts) { (ridgeline::validate(parts), ...); };
  each(options.extraction.edges, options.extraction.beyond, options.matching.candidates,
       options.matching.pairwise, options.matching.chio, options.matching.beyond,
       options.estimation.lines, options.estimation.beyond);
}

}  // namespace ridgeline::reconstruct
