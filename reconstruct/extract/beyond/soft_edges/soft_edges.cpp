// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/beyond/soft_edges/soft_edges.h"

#include "reconstruct/extract/ok2011/edge_blur.h"
#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/scene/reduced_view.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

constexpr std::array kFactors{2, 3, 4, 6, 8};
constexpr double kLong_px = 50.0;  ///< texture gives no segments of this length
/// Growth of the total length of long segments above which texture is assumed to hide edges. Sharp
/// images reach 1.06; the villages of seeds 1 to 3 without texture, blurred by 3 px, less than 1.2.
/// The soft pair of sample patch 5 (Bayer, JPEG) exceeds this limit and benefits from the
/// reduction.
constexpr double kSoft = 1.2;
/// With a smaller mean total length of long segments per view, the segments do not show whether the
/// images are soft.
constexpr double kMinLengthPerView_px = 500.0;
constexpr double kLonger = 1.03;     ///< growth by a better size; smaller growth is chance
constexpr double kWorthwhile = 1.1;  ///< growth by the wider edges of a further reduction
constexpr double kWhole = 0.8;       ///< share of an edge above which a segment shows it completely
constexpr double kMinShareOnEdge = 0.5;  ///< share of a segment that makes it a piece of an edge

using SegmentsByView = std::vector<std::vector<EdgeSegment>>;

double long_px(const SegmentsByView& by_view) {
  double sum_px = 0.0;
  for (const std::vector<EdgeSegment>& edges : by_view) {
    for (const EdgeSegment& edge : edges) {
      const double length_px = length(edge.in_image);
      if (length_px >= kLong_px) sum_px += length_px;
    }
  }
  return sum_px;
}

/// The length that a segment and an edge have in common; 0 unless the segment lies on the edge
/// along all of it.
double common_px(const Segment2& edge, const Segment2& segment, double tolerance_px) {
  constexpr double kMaxTurn_deg = 10.0;  // noise rotates short segments
  if (acute_angle_rad(edge, segment) > kMaxTurn_deg * kRadPerDeg) return 0.0;
  const double at_start = parameter_along(edge, segment.start);
  const double at_end = parameter_along(edge, segment.end);
  const double low = std::max(0.0, std::min(at_start, at_end));
  const double high = std::min(1.0, std::max(at_start, at_end));
  if (high <= low) return 0.0;
  for (const double t : {low, high}) {
    const Eigen::Vector2d x = point_at(segment, (t - at_start) / (at_end - at_start));
    if (std::abs(normal(edge).dot(x - edge.start)) > tolerance_px) return 0.0;
  }
  return (high - low) * length(edge);
}

/// Merges both lists so that each edge occurs once. A wider edge is left out if a finer segment
/// shows it completely; otherwise it replaces the finer segments that lie on it.
std::vector<EdgeSegment> merged(std::span<const EdgeSegment> finer,
                                std::span<const EdgeSegment> wider) {
  const std::vector<Segment2> lines = transformed(finer, &EdgeSegment::in_image);
  const BoxIndex2 index(lines);
  std::vector<char> is_piece(finer.size(), 0);
  std::vector<EdgeSegment> all;
  for (const EdgeSegment& edge : wider) {
    const double length_px = length(edge.in_image);
    std::vector<std::size_t> pieces;
    double longest_px = 0.0;
    for (const std::size_t i : index.near(edge.in_image, edge.scale_px)) {
      const double on_edge_px = common_px(edge.in_image, lines[i], edge.scale_px);
      longest_px = std::max(longest_px, on_edge_px);
      if (on_edge_px > kMinShareOnEdge * length(lines[i])) pieces.push_back(i);
    }
    if (longest_px >= kWhole * length_px) continue;
    for (const std::size_t i : pieces) is_piece[i] = 1;
    all.push_back(edge);
  }
  for (std::size_t i = 0; i < finer.size(); ++i) {
    if (is_piece[i] == 0) all.push_back(finer[i]);
  }
  std::ranges::stable_sort(all, std::greater{},
                           [](const EdgeSegment& edge) { return length(edge.in_image); });
  return all;
}

/// The segments of an image, which is searched again with more smoothing if its edges are wide.
std::vector<EdgeSegment> segments_at_their_width(const View& view,
                                                 double gradient_sigma_px,
                                                 const Extraction& extract) {
  // Relative to the blur. Values from 0.65 to 1 give the most roof edges in the villages of seeds 1
  // to 3 at a blur of 2, 3 and 4 px.
  constexpr double kSmoothing = 0.75;
  constexpr double kWorthwhileSmoothing = 1.1;
  std::vector<EdgeSegment> segments = extract(view, gradient_sigma_px);
  const double fitting_px = kSmoothing * blur_of_longest_px(view.image, segments).value_or(0.0);
  if (fitting_px < kWorthwhileSmoothing * gradient_sigma_px) return segments;
  return extract(view, fitting_px);
}

}  // namespace

std::vector<std::vector<EdgeSegment>> segments_at_common_size(std::span<const View* const> views,
                                                              double gradient_sigma_px,
                                                              const Extraction& extract) {
  const auto reduced_by = [&](int factor) {
    SegmentsByView found(views.size());
    tbb::parallel_for(std::size_t{0}, views.size(), [&](std::size_t i) {
      const View smaller = reduced(*views[i], factor);
      if (smaller.image.empty()) return;
      found[i] = in_pixels_of(*views[i], factor,
                              segments_at_their_width(smaller, gradient_sigma_px, extract));
    });
    return found;
  };
  SegmentsByView all = reduced_by(1);
  const double fewest_px = kMinLengthPerView_px * static_cast<double>(views.size());
  bool is_common_size = false;  // whether `all` was found at the size of most edges or finer ones
  for (const int factor : kFactors) {
    SegmentsByView found = reduced_by(factor);
    const bool is_first = factor == kFactors.front();
    if (is_first && long_px(found) <= std::max(fewest_px, kSoft * long_px(all))) break;
    is_common_size = is_common_size || long_px(found) < kLonger * long_px(all);
    if (is_common_size) {
      for (std::size_t i = 0; i < views.size(); ++i) found[i] = merged(all[i], found[i]);
      if (long_px(found) < kWorthwhile * long_px(all)) break;
    }
    all = std::move(found);
  }
  return all;
}

}  // namespace ridgeline::reconstruct
