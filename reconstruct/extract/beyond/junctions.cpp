// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/beyond/junctions.h"

#include "reconstruct/extract/ok2011/line_sums.h"
#include "reconstruct/extract/ok2011/straight_pieces.h"
#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/interruption.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kMeetingReach_px = 6.0;  ///< an edge ends slightly before the one that it meets
constexpr double kGap_px = 3.0;           ///< a strip that crosses an edge interrupts it
/// In multiples of min_length_px; short parts are matched poorly.
constexpr double kMinPartLength = 2.5;
/// Minimum improvement of the fit by two lines for a cut to be kept, root mean square (beyond.md).
constexpr double kMinJunctionBend_px = 0.05;
constexpr double kMinAngle_rad = 20.0 * kRadPerDeg;

/// The ends of all edges; end k belongs to edge k / 2.
struct Ends {
  std::vector<Segment2> places;  ///< segments of zero length
  BoxIndex2 index;
};

Ends ends_of(const std::vector<EdgeTrace>& edges) {
  std::vector<Segment2> places;
  for (const EdgeTrace& edge : edges) {
    for (const EdgeSample& end : {edge.front(), edge.back()})
      places.push_back({end.position_px, end.position_px});
  }
  return {places, BoxIndex2(places)};
}

/// The samples of a trace, in order, at which other edges end or before which the trace is
/// interrupted. A group of neighbouring samples gives one junction.
std::vector<std::size_t> junctions_of(std::size_t edge,
                                      const std::vector<EdgeTrace>& edges,
                                      const std::vector<PrincipalAxes>& axes,
                                      const Ends& ends) {
  const EdgeTrace& trace = edges[edge];
  const Eigen::Vector2d& along = axes[edge].along;
  std::vector<bool> touched(trace.size(), false);
  for (const std::size_t k :
       ends.index.near(Segment2{trace.front().position_px, trace.back().position_px},
                       kMeetingReach_px + 2.0 * axes[edge].max_distance)) {
    const std::size_t other = k / 2;
    if (other == edge || acute_angle_rad(along, axes[other].along) < kMinAngle_rad) continue;
    for (std::size_t i = 0; i < trace.size(); ++i) {
      const Eigen::Vector2d offset = ends.places[k].start - trace[i].position_px;
      if (std::abs(along.dot(offset)) <= 1.0 && offset.norm() <= kMeetingReach_px)
        touched[i] = true;
    }
  }
  for (std::size_t i = 1; i < trace.size(); ++i) {
    if ((trace[i].position_px - trace[i - 1].position_px).norm() > kGap_px) touched[i] = true;
  }
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < touched.size(); ++i) {
    if (!touched[i]) continue;
    std::size_t last = i;
    for (std::size_t k = i; k < std::min(touched.size(), last + 5); ++k) {
      if (touched[k]) last = k;
    }
    at.push_back((i + last) / 2);
    i = last;
  }
  return at;
}

/// A run of samples [first, last) with its sums.
struct TraceRun {
  std::size_t first = 0, last = 0;
  LineSums sums;
};

/// The improvement of the fit by two lines instead of one, relative to the minimum for a bend: the
/// edge bends if the value is 1 or more.
double bend_of(const TraceRun& a, const TraceRun& b, double least_bend_px) {
  // This threshold allows for the two parameters of the second line and for the correlation of edge
  // pixels.
  constexpr double kSignificant = 40.0;
  const double two_lines = a.sums.residual() + b.sums.residual();
  const LineSums both = a.sums + b.sums;
  const double gain = both.residual() - two_lines;
  const double least = both.n * least_bend_px * least_bend_px;
  const double scatter = kSignificant * two_lines / std::max(1.0, both.n - 4.0);
  return gain / std::max({least, scatter, 1e-12});
}

/// The parts of an edge between its junctions.
std::vector<TraceRun> runs_between(const Points& points,
                                   const PrincipalAxes& axes,
                                   const std::vector<std::size_t>& junctions) {
  std::vector<TraceRun> runs(1);
  const Eigen::Vector2d normal(-axes.along.y(), axes.along.x());
  auto next = junctions.begin();
  for (std::size_t i = 0; i < points.size(); ++i) {
    while (next != junctions.end() && *next < i) ++next;
    if (i > 0 && next != junctions.end() && *next == i) runs.push_back({i, i, {}});
    const Eigen::Vector2d x = points[i] - axes.centroid;
    runs.back().sums += Eigen::Vector2d(axes.along.dot(x), normal.dot(x));
    runs.back().last = i + 1;
  }
  return runs;
}

/// Repeatedly joins the two neighbouring runs with the lowest cost, until no cost is below `limit`.
/// @param cost  cost of joining two neighbours
template <typename Cost>
void join(std::vector<TraceRun>& runs, double limit, const Cost& cost) {
  while (runs.size() > 1) {
    double least = limit;
    auto first = runs.end();
    for (auto run = runs.begin(); run + 1 != runs.end(); ++run) {
      const double here = cost(run[0], run[1]);
      if (here >= least) continue;
      least = here;
      first = run;
    }
    if (first == runs.end()) return;
    *first = {first[0].first, first[1].last, first[0].sums + first[1].sums};
    runs.erase(first + 1);
  }
}

/// Joins each run that is too short to the neighbour that it continues best. If two junctions are
/// close to each other, the one at which the edge changes its course is kept.
void join_short(std::vector<TraceRun>& runs, const Points& points, double shortest_px) {
  const auto is_short = [&](const TraceRun& run) {
    return (points[run.last - 1] - points[run.first]).norm() < shortest_px;
  };
  join(runs, HUGE_VAL, [&](const TraceRun& a, const TraceRun& b) {
    if (!is_short(a) && !is_short(b)) return HUGE_VAL;
    return (a.sums + b.sums).residual() - a.sums.residual() - b.sums.residual();
  });
}

}  // namespace

std::vector<EdgeTrace> cut_at_junctions(std::vector<EdgeTrace> edges,
                                        const ExtractionOptions& options) {
  std::vector<PrincipalAxes> axes(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(),
                    [&](std::size_t i) { axes[i] = principal_axes(positions(edges[i])); });
  const Ends ends = ends_of(edges);
  std::vector<std::vector<TraceRun>> runs(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) {
    Interruption::check();
    const Points points = positions(edges[i]);
    runs[i] = runs_between(points, axes[i], junctions_of(i, edges, axes, ends));
    join_short(runs[i], points, kMinPartLength * options.edges.min_length_px);
    join(runs[i], 1.0,
         [&](const TraceRun& a, const TraceRun& b) { return bend_of(a, b, kMinJunctionBend_px); });
  });
  std::vector<EdgeTrace> cut;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (runs[i].size() == 1) {
      cut.push_back(std::move(edges[i]));
      continue;
    }
    const auto begin = edges[i].begin();
    for (const TraceRun& run : runs[i]) {
      cut.emplace_back(begin + static_cast<std::ptrdiff_t>(run.first),
                       begin + static_cast<std::ptrdiff_t>(run.last));
    }
  }
  return cut;
}

}  // namespace ridgeline::reconstruct
