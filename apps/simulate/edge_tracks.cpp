// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/edge_tracks.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace ridgeline::simulate {
namespace {

ShownEdge with_clear_runs(const ShownEdge& edge) {
  ShownEdge clear{edge.kind, edge.rank, {}};
  std::ranges::copy_if(edge.runs, std::back_inserter(clear.runs), is_clear);
  return clear;
}

/// Visible runs are in order of their views.
bool is_in_two_views(const ShownEdge& edge) {
  return !edge.runs.empty() && edge.runs.front().view != edge.runs.back().view;
}

}  // namespace

std::vector<ShownEdge> edge_tracks(std::span<const ShownEdge> edges) {
  std::vector<ShownEdge> candidates;
  for (const ShownEdge& edge : edges) {
    ShownEdge clear = with_clear_runs(edge);
    if (is_in_two_views(clear)) candidates.push_back(std::move(clear));
  }
  return without_duplicates(std::move(candidates));
}

std::string tracks_csv(std::span<const ShownEdge> tracks, std::span<const AerialView> views) {
  std::string text = "edge,kind,image,x1_px,y1_px,x2_px,y2_px,visible\n";
  int number = 0;
  for (const ShownEdge& track : tracks) {
    ++number;
    for (const VisibleRun& s : track.runs) {
      text += fmt::format("{},{},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f}\n", number, track.kind,
                          views[s.view].id, s.segment_px.start.x(), s.segment_px.start.y(),
                          s.segment_px.end.x(), s.segment_px.end.y(), s.visible_share);
    }
  }
  return text;
}

}  // namespace ridgeline::simulate
