// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/matching/track_scoring.h"

#include "evaluate/matching/on_edge.h"
#include "evaluate/statistics/summary.h"
#include "reconstruct/geometry/check.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

namespace ridgeline::evaluate {
namespace {

/// The edges on which a segment lies, with a flag for whether it certainly does.
using EdgesBeside = std::map<std::size_t, bool>;

/// How well an edge fits a track.
struct EdgeFit {
  std::set<std::size_t> views, certain_views;
  std::size_t n_observations = 0;
};

std::size_t n_views_of(const TrueEdge& edge) {
  std::set<std::size_t> views;
  for (const ObservedSegment& run : edge.runs) views.insert(run.view);
  return views.size();
}

/// The cells in which an edge counts: its class and all classes, its number of images and all
/// numbers.
class CountedCells {
 public:
  explicit CountedCells(std::span<const TrueEdge> edges) : edges_(edges) {
    for (const std::string_view line_class : {kNotAligned, kAligned, kTotal}) {
      cells_.push_back({std::string(line_class), std::nullopt, {}});
      for (std::size_t group = 0; group < kNumImageGroups; ++group)
        cells_.push_back({std::string(line_class), group, {}});
    }
  }

  template <typename Change>
  void change(std::size_t edge, const Change& change_counts) {
    const auto group = image_group(static_cast<int>(n_views_of(edges_[edge])));
    const std::string_view own = edges_[edge].is_aligned ? kAligned : kNotAligned;
    for (TrackCell& cell : cells_) {
      if (cell.line_class != own && cell.line_class != kTotal) continue;
      if (cell.group && cell.group != group) continue;
      change_counts(cell.counts);
    }
  }

  [[nodiscard]] std::vector<TrackCell> take() { return std::move(cells_); }

 private:
  std::span<const TrueEdge> edges_;
  std::vector<TrackCell> cells_;
};

void check_tracks(std::span<const std::vector<Segment2>> segments_by_view,
                  std::span<const Track> tracks,
                  std::span<const TrueEdge> edges) {
  for (const Track& track : tracks) {
    for (const Observation& s : track.observations) {
      check(s.view < segments_by_view.size(), "view = ", s.view, ", must be below ",
            segments_by_view.size());
      check(s.segment >= 0 && static_cast<std::size_t>(s.segment) < segments_by_view[s.view].size(),
            "segment = ", s.segment, ", must be below ", segments_by_view[s.view].size());
    }
  }
  for (const TrueEdge& edge : edges)
    check(n_views_of(edge) >= 2, "true edge: ", n_views_of(edge), " views, must be at least 2");
}

EdgesBeside edges_beside(std::size_t view,
                         const Segment2& segment,
                         std::span<const TrueEdge> edges) {
  EdgesBeside found;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const ObservedSegment& run : edges[e].runs) {
      if (run.view != view) continue;
      const std::optional<Beside> beside = lies_on(segment, run.px);
      if (beside) found[e] = found[e] || is_certain(*beside);
    }
  }
  return found;
}

std::map<std::size_t, EdgeFit> fits_of(const Track& track, const std::vector<EdgesBeside>& beside) {
  std::map<std::size_t, EdgeFit> fits;
  for (std::size_t s = 0; s < track.observations.size(); ++s) {
    for (const auto& [edge, certain] : beside[s]) {
      EdgeFit& fit = fits[edge];
      fit.views.insert(track.observations[s].view);
      if (certain) fit.certain_views.insert(track.observations[s].view);
      ++fit.n_observations;
    }
  }
  return fits;
}

std::optional<std::size_t> edge_of(const std::map<std::size_t, EdgeFit>& fits) {
  std::optional<std::size_t> best;
  for (const auto& [edge, fit] : fits) {
    if (fit.certain_views.empty()) continue;
    const auto rank = [](const EdgeFit& f) {
      return std::pair(f.certain_views.size(), f.n_observations);
    };
    if (!best || rank(fit) > rank(fits.at(*best))) best = edge;
  }
  return best;
}

MatchVerdict verdict_of_observation(std::size_t view,
                                    const Segment2& segment,
                                    const EdgesBeside& beside,
                                    std::size_t edge,
                                    const TrueEdge& truth) {
  if (beside.contains(edge)) return MatchVerdict::kCorrect;
  if (!beside.empty()) return MatchVerdict::kFalse;
  bool is_shown = false;
  for (const ObservedSegment& run : truth.runs) {
    if (run.view != view) continue;
    is_shown = true;
    if (continues(segment, run.px)) return MatchVerdict::kUnjudged;
  }
  return is_shown ? MatchVerdict::kFalse : MatchVerdict::kUnjudged;
}

}  // namespace

TracksScore score_tracks(std::span<const std::vector<Segment2>> segments_by_view,
                         std::span<const Track> tracks,
                         std::span<const TrueEdge> edges) {
  check_tracks(segments_by_view, tracks, edges);
  TracksScore score;
  CountedCells cells(edges);
  std::vector<std::set<std::size_t>> found_views(edges.size());
  for (const Track& track : tracks) {
    std::vector<EdgesBeside> beside;
    for (const Observation& s : track.observations)
      beside.push_back(edges_beside(s.view, segments_by_view[s.view][s.segment], edges));
    const std::map<std::size_t, EdgeFit> fits = fits_of(track, beside);
    for (const auto& [edge, fit] : fits) {
      if (fit.views.size() >= 2) found_views[edge].insert(fit.views.begin(), fit.views.end());
    }
    std::vector<MatchVerdict>& verdicts = score.verdicts.emplace_back();
    const std::optional<std::size_t> own = edge_of(fits);
    for (std::size_t s = 0; s < track.observations.size(); ++s) {
      const Observation& seen = track.observations[s];
      const MatchVerdict verdict =
          own ? verdict_of_observation(seen.view, segments_by_view[seen.view][seen.segment],
                                       beside[s], *own, edges[*own])
              : MatchVerdict::kUnjudged;
      verdicts.push_back(verdict);
      if (verdict == MatchVerdict::kUnjudged) {
        ++score.n_unjudged;
        continue;
      }
      cells.change(*own, [&](TrackCounts& c) {
        ++(verdict == MatchVerdict::kCorrect ? c.n_right : c.n_wrong);
      });
    }
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    cells.change(e, [&](TrackCounts& c) {
      ++c.n_edges;
      c.n_shown += n_views_of(edges[e]);
      if (!found_views[e].empty()) ++c.n_edges_found;
      c.n_shown_found += found_views[e].size();
    });
  }
  score.cells = cells.take();
  return score;
}

}  // namespace ridgeline::evaluate
