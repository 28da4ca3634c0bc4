// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/patch_matching.h"

#include "io/error.h"
#include "io/project/matches_file.h"
#include "io/project/reference_tracks_file.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <variant>

namespace ridgeline::apps {
namespace {

std::vector<Segment2> in_image(const std::vector<EdgeSegment>& segments) {
  return transformed(segments, &EdgeSegment::in_image);
}

std::vector<ReferenceEdge> in_windows(std::vector<ReferenceEdge> edges, const io::Patch& patch) {
  for (ReferenceEdge& edge : edges) {
    edge.base = in_window(edge.base, patch.images[0]);
    edge.other = in_window(edge.other, patch.images[1]);
  }
  return edges;
}

/// The largest epipolar angle over the pairs of runs in different views.
double largest_angle_rad(const evaluate::TrueEdge& edge, const io::Patch& patch) {
  double largest_rad = 0.0;
  for (const ObservedSegment& a : edge.runs) {
    for (const ObservedSegment& b : edge.runs) {
      if (a.view >= b.view) continue;
      largest_rad =
          std::max(largest_rad, epipolar_angle_rad({patch.images[a.view].image_from_world,
                                                    patch.images[b.view].image_from_world},
                                                   a.px, b.px));
    }
  }
  return largest_rad;
}

/// The edges visible in at least two of the first `n_views` images.
std::vector<evaluate::TrueEdge> true_edges(const io::Patch& patch,
                                           std::size_t n_views,
                                           double max_aligned_angle_deg) {
  std::vector<evaluate::TrueEdge> edges;
  const std::vector<std::string> images = transformed(patch.images, &io::PatchImage::id);
  for (const io::ReferenceTrack& track :
       io::read_reference_tracks(*patch.reference_tracks, images, patch.images_are_chosen)) {
    evaluate::TrueEdge edge;
    for (const ObservedSegment& s : track.observations) {
      if (s.view >= n_views) continue;
      const Segment2 segment = in_window(s.px, patch.images[s.view]);
      if (is_read(segment, patch.images[s.view])) edge.runs.push_back({{s.view, -1}, segment});
    }
    const bool is_in_two = std::ranges::any_of(
        edge.runs, [&](const ObservedSegment& run) { return run.view != edge.runs.front().view; });
    if (!is_in_two) continue;
    edge.is_aligned = largest_angle_rad(edge, patch) <= max_aligned_angle_deg * kRadPerDeg;
    edges.push_back(std::move(edge));
  }
  return edges;
}

void check_id(const std::string& file,
              const char* column,
              int id,
              const std::vector<EdgeSegment>& segments) {
  if (id >= 0 && static_cast<std::size_t>(id) < segments.size()) return;
  throw io::IoError(
      file,
      fmt::format("{} = {}, must be in 0..{}: the image has {} segments. Guided matches need the "
                  "segments.IMAGE.csv of their run next to them",
                  column, id, static_cast<std::ptrdiff_t>(segments.size()) - 1, segments.size()));
}

}  // namespace

void check_segment_ids(const std::string& file,
                       std::span<const Correspondence> matches,
                       const std::array<std::vector<EdgeSegment>, 2>& segments) {
  for (const Correspondence& match : matches) {
    check_id(file, "left_id", match.base, segments[0]);
    check_id(file, "right_id", match.other, segments[1]);
  }
}

std::vector<Correspondence> read_correspondences(
    const std::string& file, const std::array<std::vector<EdgeSegment>, 2>& segments) {
  std::vector<Correspondence> matches = io::read_matches(file);
  check_segment_ids(file, matches, segments);
  return matches;
}

std::optional<evaluate::MatchingScore> score_patch_matches(
    const io::Patch& patch,
    const std::array<std::vector<EdgeSegment>, 2>& segments,
    std::span<const Correspondence> matches) {
  if (!patch.reference_matches) return std::nullopt;
  const io::ReferenceMatches reference = io::read_reference_matches(*patch.reference_matches);
  if (const auto* pairs = std::get_if<std::vector<Correspondence>>(&reference)) {
    check_segment_ids(*patch.reference_matches, *pairs, segments);
    return evaluate::score_matches(matches, *pairs);
  }
  return evaluate::score_matches(
      in_image(segments[0]), in_image(segments[1]), matches,
      in_windows(std::get<std::vector<ReferenceEdge>>(reference), patch));
}

std::optional<evaluate::TracksScore> score_patch_tracks(
    const io::Patch& patch,
    std::size_t n_views,
    std::span<const std::vector<EdgeSegment>> segments,
    std::span<const Track> tracks,
    double max_aligned_angle_deg) {
  if (!patch.reference_tracks) return std::nullopt;
  return evaluate::score_tracks(transformed(segments, in_image), tracks,
                                true_edges(patch, n_views, max_aligned_angle_deg));
}

}  // namespace ridgeline::apps
