// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/beyond/close_edges/separate_edges.h"

#include "reconstruct/extract/beyond/close_edges/close_edges.h"
#include "reconstruct/extract/ok2011/edge_blur.h"
#include "reconstruct/extract/ok2011/regression_line.h"
#include "reconstruct/geometry/interruption.h"
#include "reconstruct/geometry/transformed.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

namespace ridgeline::reconstruct {
namespace {

Segment2 line_through(const EdgeTrace& trace) {
  const RegressionLine line = regression_line(positions(trace));
  return {line.centroid + line.first * line.along, line.centroid + line.last * line.along};
}

/// The edge shifted to a step of its profile; its samples keep their scatter.
EdgeTrace shifted(const EdgeTrace& trace,
                  const Segment2& line,
                  const ProfileStep& step,
                  double share_of_strength) {
  const Eigen::Vector2d n = normal(line);
  EdgeTrace moved = trace;
  for (EdgeSample& sample : moved) {
    const double tau = 2.0 * parameter_along(line, sample.position_px) - 1.0;
    sample.position_px += (step.offset_px + tau * step.tilt_px) * n;
    sample.strength *= share_of_strength;
  }
  return moved;
}

/// An edge with its line, and whether it is one of two separated edges.
struct EdgePart {
  EdgeTrace edge;
  Segment2 line;
  bool separated = false;
};

std::vector<EdgePart> parts_of(EdgeTrace edge,
                               const cv::Mat& image,
                               const CloseEdgeFinder& finder) {
  const Segment2 line = line_through(edge);
  std::vector<EdgePart> parts;
  if (const auto steps = finder.find(image, line)) {
    const double strongest = std::max((*steps)[0].height, (*steps)[1].height);
    for (const ProfileStep& step : *steps) {
      EdgeTrace trace = shifted(edge, line, step, step.height / strongest);
      const Segment2 moved = line_through(trace);
      parts.push_back({std::move(trace), moved, true});
    }
    return parts;
  }
  parts.push_back({std::move(edge), line, false});
  return parts;
}

/// Whether two lines run within a fraction of a pixel of each other over most of the shorter one.
bool same_edge(const Segment2& a, const Segment2& b) {
  constexpr double kSame_px = 0.6;
  constexpr double kMinShare = 0.6;
  const Segment2& longer = length(a) >= length(b) ? a : b;
  const Segment2& shorter = length(a) >= length(b) ? b : a;
  const double len = length(longer);
  const Eigen::Vector2d u = along(longer);
  for (const Eigen::Vector2d& x : {shorter.start, shorter.end}) {
    if (std::abs(normal_of(u).dot(x - longer.start)) > kSame_px) return false;
  }
  const auto [low, high] =
      std::minmax({u.dot(shorter.start - longer.start), u.dot(shorter.end - longer.start)});
  return std::min(high, len) - std::max(low, 0.0) >= kMinShare * (high - low);
}

double left_end(const Segment2& s) { return std::min(s.start.x(), s.end.x()); }
double right_end(const Segment2& s) { return std::max(s.start.x(), s.end.x()); }

/// Marks the parts to drop: if parts are the same edge and at least one of them is separated, only
/// the longest is kept.
std::vector<bool> repeated(const std::vector<EdgePart>& parts) {
  std::vector<std::size_t> by_left(parts.size());
  std::iota(by_left.begin(), by_left.end(), std::size_t{0});
  std::ranges::stable_sort(by_left, {}, [&](std::size_t i) { return left_end(parts[i].line); });
  std::vector<bool> drop(parts.size(), false);
  for (std::size_t i = 0; i < by_left.size(); ++i) {
    const EdgePart& a = parts[by_left[i]];
    for (std::size_t k = i + 1; k < by_left.size(); ++k) {
      const EdgePart& b = parts[by_left[k]];
      if (left_end(b.line) > right_end(a.line) + 1.0) break;
      if (!(a.separated || b.separated) || !same_edge(a.line, b.line)) continue;
      const bool a_stays = length(a.line) != length(b.line) ? length(a.line) > length(b.line)
                                                            : by_left[i] < by_left[k];
      drop[by_left[a_stays ? k : i]] = true;
    }
  }
  return drop;
}

}  // namespace

std::vector<EdgeTrace> separate_edges(std::vector<EdgeTrace> edges, const cv::Mat& image) {
  const CloseEdgeFinder finder(
      edge_blur_px(image, transformed(edges, line_through)).value_or(kTypicalBlur_px));
  std::vector<std::vector<EdgePart>> found(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) {
    Interruption::check();
    found[i] = parts_of(std::move(edges[i]), image, finder);
  });
  std::vector<EdgePart> parts;
  for (std::vector<EdgePart>& some : found) {
    std::move(some.begin(), some.end(), std::back_inserter(parts));
  }
  const std::vector<bool> drop = repeated(parts);
  std::vector<EdgeTrace> separated;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!drop[i]) separated.push_back(std::move(parts[i].edge));
  }
  return separated;
}

}  // namespace ridgeline::reconstruct
