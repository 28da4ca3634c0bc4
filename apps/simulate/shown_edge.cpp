// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/shown_edge.h"

#include "apps/simulate/edge_contrast.h"
#include "apps/simulate/physical_edges.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace ridgeline::simulate {
namespace {

/// Minimum mean difference between the sides of a clear edge, as a share of the image's range.
constexpr double kMinContrast = 0.03;

std::vector<VisibleRun> runs(const SurfaceOracle& oracle, std::size_t view, const Segment3& edge) {
  const std::vector<PlanInterval> runs = visible_runs(oracle, view, edge);
  const double visible_share = total_length(runs);
  std::vector<VisibleRun> result;
  result.reserve(runs.size());
  for (const PlanInterval& run : runs) {
    result.push_back({view, run, image_of(oracle, view, edge, run), visible_share});
  }
  return result;
}

/// Whether most of a segment lies within a pixel of another one.
bool covered_by(const Segment2& segment, const Segment2& other) {
  constexpr double kWithinPx = 1.0;
  constexpr double kMinCoveredShare = 0.7;
  const int samples = 1 + static_cast<int>(length(segment));
  int covered = 0;
  for (int i = 0; i < samples; ++i) {
    covered += distance(other, point_at(segment, (i + 0.5) / samples)) < kWithinPx ? 1 : 0;
  }
  return covered >= kMinCoveredShare * samples;
}

bool covered_by(const ShownEdge& edge, const ShownEdge& other) {
  return std::ranges::all_of(edge.runs, [&](const VisibleRun& s) {
    return std::ranges::any_of(other.runs, [&](const VisibleRun& t) {
      return t.view == s.view && covered_by(s.segment_px, t.segment_px);
    });
  });
}

double length_in_first_view_px(const ShownEdge& edge) {
  double sum_px = 0.0;
  for (const VisibleRun& s : edge.in_view(edge.runs.front().view)) {
    sum_px += length(s.segment_px);
  }
  return sum_px;
}

}  // namespace

std::vector<VisibleRun> ShownEdge::in_view(std::size_t view) const {
  std::vector<VisibleRun> result;
  std::ranges::copy_if(runs, std::back_inserter(result),
                       [&](const VisibleRun& s) { return s.view == view; });
  return result;
}

std::vector<ShownEdge> shown_edges(const SyntheticScene& scene, const SurfaceOracle& oracle) {
  const std::vector<PhysicalEdge> edges = physical_edges(scene);
  std::vector<ShownEdge> result(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) {
    ShownEdge& shown = result[i];
    shown.kind = edges[i].kind;
    shown.rank = edges[i].rank;
    for (std::size_t view = 0; view < oracle.num_views(); ++view) {
      std::ranges::move(runs(oracle, view, edges[i].segment), std::back_inserter(shown.runs));
    }
  });
  return result;
}

void measure_contrast(std::size_t view, const ImageWindow& village, std::span<ShownEdge> edges) {
  tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) {
    for (VisibleRun& s : edges[i].runs) {
      if (s.view == view) s.contrast = contrast_across(village, s.segment_px);
    }
  });
}

bool is_clear(const VisibleRun& run) {
  return length(run.segment_px) >= kMinShownLength_px && run.contrast >= kMinContrast;
}

std::vector<ShownEdge> without_duplicates(std::vector<ShownEdge> edges) {
  std::ranges::stable_sort(edges, {}, [](const ShownEdge& edge) {
    return std::pair(edge.rank, -length_in_first_view_px(edge));
  });
  std::vector<ShownEdge> kept;
  for (ShownEdge& edge : edges) {
    const bool duplicate =
        std::ranges::any_of(kept, [&](const ShownEdge& other) { return covered_by(edge, other); });
    if (!duplicate) kept.push_back(std::move(edge));
  }
  std::ranges::stable_sort(kept, {}, [](const ShownEdge& edge) {
    const VisibleRun& first = edge.runs.front();
    return std::tuple(first.view, first.segment_px.start.x(), first.segment_px.start.y());
  });
  return kept;
}

}  // namespace ridgeline::simulate
