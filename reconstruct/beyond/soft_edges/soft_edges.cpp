// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/soft_edges/soft_edges.h"

#include "reconstruct/geometry/transformed.h"
#include "reconstruct/ok2011/extract/edge_blur.h"
#include "reconstruct/views/reduced_view.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

constexpr std::array kFactors{2, 3, 4, 6, 8};
constexpr double kLong_px = 50.0;  ///< texture gives no segments of this length
/// Growth of the length of long segments by which texture hides the edges of images. Sharp images
/// reach 1.06. The soft pair of sample patch 5 (Bayer, JPEG) exceeds 1.2 and gains by it; some
/// views of the villages of seeds 1 to 3, which have no such texture, exceed it with a blur of 3 px
/// and lose 2 % of their roof edges.
constexpr double kSoft = 1.2;
/// Long segments of less length in a view, on average, do not show whether its image is soft.
constexpr double kFewest_px = 500.0;

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

/// The segments of an image, searched again with more smoothing if its edges ask for it.
std::vector<EdgeSegment> segments_at_their_width(const View& view,
                                                 double gradient_sigma_px,
                                                 const Extraction& extract) {
  // Of the blur. From 0.65 to 1 the villages of seeds 1 to 3 give the most roof edges at a blur of
  // 2, 3 and 4 px.
  constexpr double kSmoothing = 0.75;
  constexpr double kWorthwhileSmoothing = 1.1;
  std::vector<EdgeSegment> segments = extract(view, gradient_sigma_px);
  const double fitting_px = kSmoothing * edge_blur_px(view.image, segments).value_or(0.0);
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
  SegmentsByView best = reduced_by(1);
  double growth = kSoft;
  for (const int factor : kFactors) {
    SegmentsByView found = reduced_by(factor);
    const double fewest_px = kFewest_px * static_cast<double>(views.size());
    if (long_px(found) <= std::max(fewest_px, growth * long_px(best))) break;
    best = std::move(found);
    growth = 1.0;
  }
  return best;
}

}  // namespace ridgeline::reconstruct
