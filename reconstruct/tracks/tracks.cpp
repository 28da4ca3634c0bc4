// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/tracks/tracks.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/interruption.h"
#include "reconstruct/tracks/segment_depth.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <tuple>

namespace ridgeline::reconstruct {
namespace {

/// Records which segments are already in a track.
class TakenSegments {
 public:
  explicit TakenSegments(const SearchedViews& views) {
    for (std::size_t v = 0; v < views.size(); ++v) is_taken_.emplace_back(views.n_segments(v), 0);
  }
  [[nodiscard]] bool is_free(const Observation& s) const {
    return is_taken_[s.view][static_cast<std::size_t>(s.segment)] == 0;
  }
  void take(const Track& track) {
    for (const Observation& s : track.observations)
      is_taken_[s.view][static_cast<std::size_t>(s.segment)] = 1;
  }

 private:
  std::vector<std::vector<char>> is_taken_;
};

/// The tracks of three or more views.
std::vector<Track> tracks_by_geometry(const SearchedViews& views,
                                      const CandidateOptions& candidates,
                                      const TrackOptions& options,
                                      TakenSegments& taken) {
  const IsFree is_free = [&](const Observation& s) { return taken.is_free(s); };
  std::vector<Observation> references;
  for (std::size_t v = 0; v < views.size(); ++v) {
    for (std::size_t s = 0; s < views.n_segments(v); ++s)
      references.push_back({v, static_cast<int>(s)});
  }
  std::vector<std::optional<ProposedTrack>> proposed(references.size());
  tbb::parallel_for(std::size_t{0}, references.size(), [&](std::size_t i) {
    Interruption::check();
    proposed[i] = propose_track(views, references[i], candidates, options, is_free);
  });
  const auto is_after = [&](std::size_t a, std::size_t b) {
    return std::tuple(-proposed[a]->log_odds, a) > std::tuple(-proposed[b]->log_odds, b);
  };
  std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(is_after)> queue(is_after);
  for (std::size_t i = 0; i < proposed.size(); ++i) {
    if (proposed[i]) queue.push(i);
  }
  std::vector<Track> tracks;
  while (!queue.empty()) {
    const std::size_t i = queue.top();
    queue.pop();
    if (!is_free(references[i])) continue;
    if (!std::ranges::all_of(proposed[i]->observations, is_free)) {
      proposed[i] = propose_track(views, references[i], candidates, options, is_free);
      if (proposed[i]) queue.push(i);
      continue;
    }
    add_pieces(views, options, is_free, *proposed[i]);
    tracks.push_back(Track{proposed[i]->observations});
    taken.take(tracks.back());
  }
  return tracks;
}

bool is_near_aligned(const Scene& scene,
                     const Observation& a,
                     const Observation& b,
                     double max_angle_deg) {
  const std::array cameras{scene.views[a.view].image_from_local,
                           scene.views[b.view].image_from_local};
  const auto segment = [&](const Observation& s) -> const Segment2& {
    return scene.views[s.view].segments[static_cast<std::size_t>(s.segment)].line.segment;
  };
  return epipolar_angle_rad(cameras, segment(a), segment(b)) <= max_angle_deg * kRadPerDeg;
}

/// Adds tracks of two views from matches by appearance whose segments are in no track, and extends
/// near-aligned ones to further views.
void add_tracks_by_appearance(const Scene& scene,
                              std::span<const MatchedPair> pairs,
                              TakenSegments& taken,
                              std::vector<Track>& tracks) {
  std::map<Observation, std::size_t> aligned;  // index of the track of each segment
  for (const auto& [views, matches] : pairs) {
    for (const Correspondence& match : matches) {
      const Observation base{views.base, match.base};
      const Observation other{views.search, match.other};
      const bool base_is_free = taken.is_free(base);
      const bool other_is_free = taken.is_free(other);
      if (!base_is_free && !other_is_free) continue;
      const bool is_aligned = is_near_aligned(scene, base, other, kMaxAlignedAngle_deg);
      std::size_t track = tracks.size();
      if (base_is_free && other_is_free) {
        tracks.push_back(Track{{base, other}});
      } else {
        const auto known = aligned.find(base_is_free ? other : base);
        if (!is_aligned || known == aligned.end()) continue;
        track = known->second;
        tracks[track].observations.push_back(base_is_free ? base : other);
      }
      taken.take(Track{{base, other}});
      if (is_aligned) aligned[base] = aligned[other] = track;
    }
  }
}

/// Puts two observations of a matched pair first, base before search, and the others in ascending
/// order.
void order_observations(std::span<const MatchedPair> pairs, Track& track) {
  std::ranges::sort(track.observations);
  for (const MatchedPair& pair : pairs) {
    const auto base = std::ranges::find(track.observations, pair.views.base, &Observation::view);
    const auto search =
        std::ranges::find(track.observations, pair.views.search, &Observation::view);
    if (base == track.observations.end() || search == track.observations.end()) continue;
    const std::array first{*base, *search};
    std::erase_if(track.observations,
                  [&](const Observation& s) { return s == first[0] || s == first[1]; });
    track.observations.insert(track.observations.begin(), first.begin(), first.end());
    return;
  }
  const auto other = std::ranges::find_if(
      track.observations, [&](const Observation& s) { return s.view != track.base().view; });
  std::rotate(track.observations.begin() + 1, other, other + 1);
}

}  // namespace

std::vector<Track> tracks_of(const Scene& scene,
                             std::span<const MatchedPair> pairs,
                             const CandidateOptions& candidates,
                             const TrackOptions& options) {
  validate(options);
  const SearchedViews views(scene, pairs);
  TakenSegments taken(views);
  std::vector<Track> tracks = tracks_by_geometry(views, candidates, options, taken);
  add_tracks_by_appearance(scene, pairs, taken, tracks);
  for (Track& track : tracks) order_observations(pairs, track);
  std::ranges::sort(tracks, {}, &Track::observations);
  return tracks;
}

}  // namespace ridgeline::reconstruct
