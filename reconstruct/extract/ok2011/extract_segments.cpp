// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/extract_segments.h"

#include "reconstruct/extract/ok2011/bends.h"
#include "reconstruct/extract/ok2011/edge_chains.h"
#include "reconstruct/extract/ok2011/edge_detection.h"
#include "reconstruct/extract/ok2011/edge_segments.h"
#include "reconstruct/extract/ok2011/line_tracer.h"
#include "reconstruct/extract/ok2011/straight_pieces.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/transformed.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <functional>

namespace ridgeline::reconstruct {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// Minimum significance() of an edge: a short edge must be strong and a faint one long. Chance
/// alignments in texture are neither strong nor long. Ours.
constexpr double kMinSignificance = 10.0;

/// Whether any pixel of the chain is stronger than the high threshold (hysteresis).
bool has_strong_pixel(const Chain& chain,
                      std::span<const EdgePixel> pixels,
                      const NoiseGrid& noise,
                      double factor) {
  return std::any_of(chain.begin(), chain.end(), [&](int i) {
    const EdgePixel& pixel = pixels[i];
    return pixel.gradient.norm() > factor * noise.at(pixel.x, pixel.y);
  });
}

/// The straight pieces of the edges of the image, longest first.
std::vector<Points> detected_pieces(const cv::Mat& image,
                                    const NoiseGrid& noise,
                                    const ExtractOptions& options) {
  const std::vector<EdgePixel> pixels = detected_edge_pixels(image, noise, options);
  const cv::Mat index = edge_pixel_index(pixels, image.size());
  std::vector<Points> all;
  for (const Chain& chain : linked_chains(pixels, index)) {
    if (!has_strong_pixel(chain, pixels, noise, options.high_noise_factor)) continue;
    const Points points = transformed(
        chain, [&](int i) { return Eigen::Vector2d(pixels[i].position_px.cast<double>()); });
    for (const Piece& piece : straight_pieces(points, options)) {
      all.emplace_back(points.begin() + piece.first, points.begin() + piece.last);
    }
  }
  std::ranges::stable_sort(all, std::greater{}, std::ranges::size);
  return all;
}

/// Mean ratio of strength to noise, multiplied by the square root of the number of samples.
double significance(const EdgeTrace& trace, const NoiseGrid& noise) {
  double sum = 0.0;
  for (const EdgeSample& sample : trace) {
    const auto x = static_cast<int>(std::lround(sample.position_px.x()));
    const auto y = static_cast<int>(std::lround(sample.position_px.y()));
    sum += sample.strength / noise.at(x, y);
  }
  return sum / std::sqrt(static_cast<double>(trace.size()));
}

/// The parts of a trace that are straight to within a fraction of a pixel. Parts with fewer than
/// three samples are left out, because two samples always fit a line.
std::vector<EdgeTrace> straight_parts(const EdgeTrace& trace, const ExtractOptions& options) {
  const Points points = positions(trace);
  const std::vector<std::size_t> borders = bends(points, options);
  std::vector<EdgeTrace> parts;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    if (borders[i + 1] - borders[i] < 3) continue;
    const std::span<const Eigen::Vector2d> part =
        std::span(points).subspan(borders[i], borders[i + 1] - borders[i]);
    if (principal_axes(part).lambda_min > kMaxLambdaMinPx2) continue;
    parts.emplace_back(trace.begin() + static_cast<std::ptrdiff_t>(borders[i]),
                       trace.begin() + static_cast<std::ptrdiff_t>(borders[i + 1]));
  }
  return parts;
}

}  // namespace

std::vector<EdgeTrace> edge_traces(const ImagePart& image,
                                   const ExtractOptions& options,
                                   std::span<const EdgeTrace> known) {
  const GradientImage gradient = gradient_image(image, options);
  LineTracer tracer(gradient, options);
  for (const EdgeTrace& edge : known) tracer.claim(edge);
  std::vector<EdgeTrace> edges;
  for (const Points& piece : detected_pieces(image.pixels, gradient.noise, options)) {
    const auto trace = tracer.trace(piece);
    if (!trace) continue;
    for (EdgeTrace& part : straight_parts(*trace, options)) {
      const Eigen::Vector2d chord = part.back().position_px - part.front().position_px;
      if (chord.norm() < options.min_length_px) continue;
      if (significance(part, gradient.noise) < kMinSignificance) continue;
      tracer.claim(part);
      edges.push_back(std::move(part));
    }
  }
  return edges;
}

std::vector<EdgeSegment> extract_segments(const ImagePart& image,
                                          const PixelMap& ideal_from_image,
                                          const ExtractOptions& options,
                                          const EdgeRefinement& refine) {
  check(!image.pixels.empty() && image.pixels.depth() == CV_32F && image.pixels.channels() <= 4,
        "extract_segments: the image must have 1 to 4 bands of float");
  validate(options);
  std::vector<EdgeTrace> edges = edge_traces(image, options);
  if (refine) edges = refine(std::move(edges), image);
  return edge_segments(edges, image.pixels, ideal_from_image, options);
}

}  // namespace ridgeline::reconstruct
