// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/edge_segments.h"

#include "reconstruct/appearance/flanks.h"
#include "reconstruct/extract/ok2011/regression_line.h"
#include "reconstruct/geometry/interruption.h"

#include <tbb/parallel_for.h>

namespace ridgeline::reconstruct {
namespace {

/// The lines of one edge in both kinds of pixels.
struct EdgeLines {
  const EdgeTrace* trace = nullptr;
  RegressionLine in_image;
  RegressionLine ideal;
};

/// Maps the points to ideal pixels; returns false if any of them has none.
bool map_points(std::span<Eigen::Vector2d> points, const PixelMap& ideal_from_image) {
  for (Eigen::Vector2d& point : points) {
    const auto mapped = ideal_from_image(point);
    if (!mapped) return false;
    point = *mapped;
  }
  return true;
}

std::optional<EdgeLines> lines_of(const EdgeTrace& edge, const PixelMap& ideal_from_image) {
  std::vector<Eigen::Vector2d> points = positions(edge);
  EdgeLines lines{&edge, regression_line(points), {}};
  if (ideal_from_image && !map_points(points, ideal_from_image)) return std::nullopt;
  lines.ideal = ideal_from_image ? regression_line(points) : lines.in_image;
  return lines;
}

double mean_strength(const EdgeTrace& trace) {
  double sum = 0.0;
  for (const EdgeSample& sample : trace) sum += sample.strength;
  return trace.empty() ? 0.0 : sum / static_cast<double>(trace.size());
}

EdgeSegment segment_of(const EdgeLines& lines,
                       const EdgeNoise& noise,
                       const SystematicError& systematic,
                       const cv::Mat& image) {
  EdgeSegment segment;
  segment.line = uncertain_segment(lines.ideal, noise, systematic);
  segment.in_image = uncertain_segment(lines.in_image, noise, systematic).segment;
  segment.n_edge_pixels = static_cast<int>(lines.trace->size());
  segment.rms_px = lines.ideal.rms_px;
  segment.contrast = mean_strength(*lines.trace);
  set_flanks(image, segment);
  return segment;
}

}  // namespace

std::vector<EdgeSegment> edge_segments(const std::vector<EdgeTrace>& edges,
                                       const cv::Mat& image,
                                       const PixelMap& ideal_from_image,
                                       const ExtractOptions& options) {
  std::vector<std::optional<EdgeLines>> fitted(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(),
                    [&](std::size_t i) { fitted[i] = lines_of(edges[i], ideal_from_image); });
  std::vector<EdgeLines> lines;
  std::vector<RegressionLine> ideal;
  for (std::optional<EdgeLines>& one : fitted) {
    if (!one) continue;
    ideal.push_back(one->ideal);
    lines.push_back(std::move(*one));
  }
  const EdgeNoise noise = edge_noise(ideal);
  const SystematicError systematic{options.systematic_across_px, options.systematic_ends_px};
  std::vector<EdgeSegment> segments(lines.size());
  tbb::parallel_for(std::size_t{0}, lines.size(), [&](std::size_t i) {
    Interruption::check();
    segments[i] = segment_of(lines[i], noise, systematic, image);
  });
  return segments;
}

}  // namespace ridgeline::reconstruct
