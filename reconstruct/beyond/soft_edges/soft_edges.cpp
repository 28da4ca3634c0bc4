// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/soft_edges/soft_edges.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/segment_index.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/ok2011/extract/edge_blur.h"
#include "reconstruct/views/reduced_view.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

constexpr int kMostHalvings = 3;
constexpr double kLong_px = 50.0;  ///< texture gives no segments of this length
/// Growth of the length of long segments by which texture hides the edges of an image. Sharp images
/// reach 1.06. The soft pair of sample patch 5 (Bayer, JPEG) exceeds 1.2 and gains by it; some
/// views of the villages of seeds 1 to 3, which have no such texture, exceed it with a blur of 3 px
/// and lose 2 % of their roof edges.
constexpr double kSoft = 1.2;
/// Long segments of less length in all do not show whether an image is soft.
constexpr double kFewest_px = 500.0;
constexpr double kWorthwhile = 1.1;  ///< growth by the wider edges of a further reduction
constexpr double kWhole = 0.8;       ///< share of an edge that shows it as a whole
constexpr double kMostOn = 0.5;      ///< share of a segment that makes it a piece of an edge

double long_px(std::span<const EdgeSegment> edges) {
  double sum_px = 0.0;
  for (const EdgeSegment& edge : edges) {
    const double length_px = length(edge.in_image);
    if (length_px >= kLong_px) sum_px += length_px;
  }
  return sum_px;
}

/// The length of the stretch that a segment and an edge have in common; 0 unless the segment lies
/// on the edge all along it.
double common_px(const Segment2& edge, const Segment2& segment, double tolerance_px) {
  constexpr double kMostTurn_deg = 10.0;  // short segments are turned by their noise
  if (acute_angle_rad(edge, segment) > kMostTurn_deg * kRadPerDeg) return 0.0;
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

/// Both lists with each edge once. A wider edge is left out if a finer segment shows it as a whole.
/// If not, it takes the place of the finer segments that lie on it.
std::vector<EdgeSegment> merged(std::span<const EdgeSegment> finer,
                                std::span<const EdgeSegment> wider) {
  const std::vector<Segment2> lines = transformed(finer, &EdgeSegment::in_image);
  const SegmentIndex index(lines);
  std::vector<char> is_piece(finer.size(), 0);
  std::vector<EdgeSegment> all;
  for (const EdgeSegment& edge : wider) {
    const double length_px = length(edge.in_image);
    std::vector<std::size_t> pieces;
    double longest_px = 0.0;
    for (const int id : index.near(edge.in_image, edge.scale_px)) {
      const auto i = static_cast<std::size_t>(id);
      const double on_edge_px = common_px(edge.in_image, lines[i], edge.scale_px);
      longest_px = std::max(longest_px, on_edge_px);
      if (on_edge_px > kMostOn * length(lines[i])) pieces.push_back(i);
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

/// The segments of an image, searched again with more smoothing if its edges ask for it.
std::vector<EdgeSegment> segments_at_their_width(const View& view,
                                                 double gradient_sigma_px,
                                                 const Extraction& extract) {
  // Of the blur. From 0.65 to 1 the villages of seeds 1 to 3 give the most roof edges at a blur of
  // 2, 3 and 4 px.
  constexpr double kSmoothing = 0.75;
  constexpr double kWorthwhileSmoothing = 1.1;
  std::vector<EdgeSegment> segments = extract(view, gradient_sigma_px);
  std::vector<Segment2> lines = transformed(segments, &EdgeSegment::in_image);
  std::ranges::stable_sort(lines, std::greater{}, [](const Segment2& s) { return length(s); });
  const double fitting_px = kSmoothing * edge_blur_px(view.image, lines).value_or(0.0);
  if (fitting_px < kWorthwhileSmoothing * gradient_sigma_px) return segments;
  return extract(view, fitting_px);
}

}  // namespace

std::vector<EdgeSegment> segments_at_their_scales(const View& view,
                                                  double gradient_sigma_px,
                                                  const Extraction& extract) {
  std::vector<EdgeSegment> all = segments_at_their_width(view, gradient_sigma_px, extract);
  bool is_sharp = false;  // whether the edges of the image that `all` was found in are sharp
  for (int i = 1; i <= kMostHalvings; ++i) {
    const int factor = 1 << i;
    const View smaller = reduced(view, factor);
    if (smaller.image.empty()) break;
    std::vector<EdgeSegment> found =
        in_pixels_of(view, factor, segments_at_their_width(smaller, gradient_sigma_px, extract));
    is_sharp = is_sharp || long_px(found) <= std::max(kFewest_px, kSoft * long_px(all));
    if (!is_sharp) {
      all = std::move(found);
      continue;
    }
    if (i == 1) break;  // sharp at full size
    std::vector<EdgeSegment> both = merged(all, found);
    if (long_px(both) < kWorthwhile * long_px(all)) break;
    all = std::move(both);
  }
  return all;
}

}  // namespace ridgeline::reconstruct
