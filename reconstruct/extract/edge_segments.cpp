// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/edge_segments.h"

#include "reconstruct/extract/flanks.h"
#include "reconstruct/extract/regression_line.h"

#include <tbb/parallel_for.h>

namespace ridgeline::reconstruct {
namespace {

/// The regression lines of one trace.
struct TraceLines {
  const EdgeTrace* trace = nullptr;
  RegressionLine in_image;
  RegressionLine ideal;
};

std::optional<TraceLines> lines_of(const EdgeTrace& trace, const PixelMap& ideal_from_image) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(trace.size());
  for (const EdgeSample& sample : trace) points.push_back(sample.position_px);
  TraceLines lines{&trace, regression_line(points), {}};
  if (!ideal_from_image) {
    lines.ideal = lines.in_image;
    return lines;
  }
  for (Eigen::Vector2d& point : points) {
    const auto mapped = ideal_from_image(point);
    if (!mapped) return std::nullopt;
    point = *mapped;
  }
  lines.ideal = regression_line(points);
  return lines;
}

double mean_strength(const EdgeTrace& trace) {
  double sum = 0.0;
  for (const EdgeSample& sample : trace) sum += sample.strength;
  return sum / static_cast<double>(trace.size());
}

void reverse(Segment2& segment) { std::swap(segment.start, segment.end); }

EdgeSegment segment_of(const TraceLines& lines, const EdgeNoise& noise, const cv::Mat& image) {
  EdgeSegment segment;
  segment.line = uncertain_segment(lines.ideal, noise);
  segment.in_image = uncertain_segment(lines.in_image, noise).segment;
  segment.n_edge_pixels = static_cast<int>(lines.trace->size());
  segment.rms_px = lines.ideal.rms_px;
  segment.contrast = mean_strength(*lines.trace);
  const auto [left, right] = flanks(image, segment.in_image);
  segment.left = left;
  segment.right = right;
  if (left.grey > right.grey) {
    std::swap(segment.left, segment.right);
    reverse(segment.in_image);
    reverse(segment.line.segment);
  }
  return segment;
}

}  // namespace

std::vector<EdgeSegment> edge_segments(const std::vector<EdgeTrace>& traces,
                                       const cv::Mat& image,
                                       const PixelMap& ideal_from_image) {
  std::vector<std::optional<TraceLines>> fitted(traces.size());
  tbb::parallel_for(std::size_t{0}, traces.size(),
                    [&](std::size_t i) { fitted[i] = lines_of(traces[i], ideal_from_image); });
  std::vector<TraceLines> lines;
  std::vector<RegressionLine> ideal;
  for (std::optional<TraceLines>& one : fitted) {
    if (!one) continue;
    ideal.push_back(one->ideal);
    lines.push_back(std::move(*one));
  }
  const EdgeNoise noise = edge_noise(ideal);
 
    fprintf(stderr, "noise var %g corr %g n %zu\n", noise.variance_px2, noise.correlation,
            ideal.size());
  std::vector<EdgeSegment> segments(lines.size());
  tbb::parallel_for(std::size_t{0}, lines.size(),
                    [&](std::size_t i) { segments[i] = segment_of(lines[i], noise, image); });
  return segments;
}

}  // namespace ridgeline::reconstruct
