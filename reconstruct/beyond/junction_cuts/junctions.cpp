// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/junction_cuts/junctions.h"

#include "reconstruct/ok2011/extract/line_sums.h"
#include "reconstruct/ok2011/extract/straight_pieces.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_map>

namespace ridgeline::reconstruct {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kMeetingReach_px = 6.0;  ///< an edge ends a little before the one that it meets
constexpr double kGap_px = 3.0;           ///< a strip that crosses an edge interrupts it
constexpr double kShortestPart = 2.5;     ///< of min_length_px: short parts are matched badly
constexpr double kMinAngle_rad = 20.0 * std::numbers::pi / 180.0;

/// An end of an edge.
struct End {
  std::size_t edge = 0;
  Eigen::Vector2d x_px, along;
};

/// The ends of all edges by cells of the image.
class EndIndex {
 public:
  explicit EndIndex(const std::vector<PrincipalAxes>& axes,
                    const std::vector<DetectedEdge>& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      for (const EdgeSample& end : {edges[i].trace.front(), edges[i].trace.back()}) {
        ends_[key(cell_of(end.position_px.x()), cell_of(end.position_px.y()))].push_back(
            {i, end.position_px, axes[i].along});
      }
    }
  }

  /// Calls `visit(end)` for the ends in the cells around a point.
  template <typename Visit>
  void around(const Eigen::Vector2d& x_px, const Visit& visit) const {
    const int cx = cell_of(x_px.x());
    const int cy = cell_of(x_px.y());
    for (int y = cy - 1; y <= cy + 1; ++y) {
      for (int x = cx - 1; x <= cx + 1; ++x) {
        const auto found = ends_.find(key(x, y));
        if (found == ends_.end()) continue;
        for (const End& end : found->second) visit(end);
      }
    }
  }

 private:
  static int cell_of(double x) { return static_cast<int>(std::floor(x / kMeetingReach_px)); }
  static std::uint64_t key(int x, int y) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32U) |
           static_cast<std::uint32_t>(y);
  }
  std::unordered_map<std::uint64_t, std::vector<End>> ends_;
};

/// The samples of a trace at which other edges end or beyond which it is interrupted, in order; one of
/// a group of neighbours.
std::vector<std::size_t> junctions_of(std::size_t edge,
                                      const std::vector<DetectedEdge>& edges,
                                      const PrincipalAxes& axes,
                                      const EndIndex& index) {
  const EdgeTrace& trace = edges[edge].trace;
  std::vector<bool> touched(trace.size(), false);
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const Eigen::Vector2d& x = trace[i].position_px;
    index.around(x, [&](const End& end) {
      const double sine = std::abs(axes.along.x() * end.along.y() - axes.along.y() * end.along.x());
      if (end.edge == edge || sine < std::sin(kMinAngle_rad)) return;
      const Eigen::Vector2d offset = end.x_px - x;
      // the sample beside the end
      if (offset.norm() > kMeetingReach_px || std::abs(axes.along.dot(offset)) > 1.0) return;
      touched[i] = true;
    });
    if (i > 0 && (x - trace[i - 1].position_px).norm() > kGap_px) touched[i] = true;
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

/// A run of samples [first, last) and its sums.
struct Run {
  std::size_t first = 0, last = 0;
  LineSums sums;
};

/// How much better two lines fit than one, relative to what a bend takes; a bend from 1 on.
double bend_of(const Run& a, const Run& b, const ExtractOptions& options) {
  // of the two parameters of the second line, for edge pixels that are correlated
  constexpr double kSignificant = 40.0;
  const double two_lines = a.sums.residual() + b.sums.residual();
  const LineSums both = a.sums + b.sums;
  const double gain = both.residual() - two_lines;
  const double least = both.n * options.min_junction_bend_px * options.min_junction_bend_px;
  const double scatter = kSignificant * two_lines / std::max(1.0, both.n - 4.0);
  return gain / std::max({least, scatter, 1e-12});
}

/// The parts of an edge between its junctions.
std::vector<Run> runs_between(const Points& points,
                              const PrincipalAxes& axes,
                              const std::vector<std::size_t>& junctions) {
  std::vector<Run> runs(1);
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

/// Joins a run with the next one.
void join_at(std::vector<Run>& runs, std::size_t i) {
  runs[i] = {runs[i].first, runs[i + 1].last, runs[i].sums + runs[i + 1].sums};
  runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(i) + 1);
}

/// What one line leaves unexplained of a run and the next one, beyond what two do.
double cost_of_joining(const std::vector<Run>& runs, std::size_t i) {
  return (runs[i].sums + runs[i + 1].sums).residual() - runs[i].sums.residual() -
         runs[i + 1].sums.residual();
}

/// Joins what is too short for a part to the neighbour that it continues best: of two junctions close
/// to each other the one stays at which the edge changes its course.
void join_short(std::vector<Run>& runs, const Points& points, const ExtractOptions& options) {
  const double shortest_px = kShortestPart * options.min_length_px;
  const auto is_short = [&](const Run& run) {
    return (points[run.last - 1] - points[run.first]).norm() < shortest_px;
  };
  while (runs.size() > 1) {
    double least = HUGE_VAL;
    std::size_t at = runs.size();
    for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
      if (!is_short(runs[i]) && !is_short(runs[i + 1])) continue;
      const double cost = cost_of_joining(runs, i);
      if (cost >= least) continue;
      least = cost;
      at = i;
    }
    if (at == runs.size()) return;
    join_at(runs, at);
  }
}

/// Joins neighbours until all that remain differ.
void join(std::vector<Run>& runs, const ExtractOptions& options) {
  while (runs.size() > 1) {
    double least = 1.0;
    std::size_t at = runs.size();
    for (std::size_t i = 0; i + 1 < runs.size(); ++i) {
      const double bend = bend_of(runs[i], runs[i + 1], options);
      if (bend >= least) continue;
      least = bend;
      at = i;
    }
    if (at == runs.size()) return;
    join_at(runs, at);
  }
}

}  // namespace

std::vector<DetectedEdge> cut_at_junctions(std::vector<DetectedEdge> edges,
                                           const ExtractOptions& options) {
  std::vector<PrincipalAxes> axes(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(),
                    [&](std::size_t i) { axes[i] = principal_axes(positions(edges[i].trace)); });
  const EndIndex index(axes, edges);
  std::vector<std::vector<Run>> runs(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) {
    const Points points = positions(edges[i].trace);
    runs[i] = runs_between(points, axes[i], junctions_of(i, edges, axes[i], index));
    join_short(runs[i], points, options);
    join(runs[i], options);
  });
  std::vector<DetectedEdge> cut;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (runs[i].size() == 1) {
      cut.push_back(std::move(edges[i]));
      continue;
    }
    const auto begin = edges[i].trace.begin();
    for (const Run& run : runs[i]) {
      cut.push_back({EdgeTrace(begin + static_cast<std::ptrdiff_t>(run.first),
                               begin + static_cast<std::ptrdiff_t>(run.last)),
                     std::nullopt});
    }
  }
  return cut;
}

}  // namespace ridgeline::reconstruct
