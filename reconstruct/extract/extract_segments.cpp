// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/extract_segments.h"

#include "reconstruct/extract/colour_gradient.h"
#include "reconstruct/extract/edge_chains.h"
#include "reconstruct/extract/edge_pixels.h"
#include "reconstruct/extract/flanks.h"
#include "reconstruct/extract/straight_pieces.h"
#include "reconstruct/geometry/check.h"

#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

/// Median strength of the gradient over that of a Rayleigh distribution of sigma 1.
double gradient_noise(const cv::Mat& gradient) {
  std::vector<float> strengths;
  for (int y = 0; y < gradient.rows; y += 4) {
    for (int x = 0; x < gradient.cols; x += 4) {
      const auto& g = gradient.at<cv::Vec2f>(y, x);
      strengths.push_back(std::sqrt(g.dot(g)));
    }
  }
  auto middle = strengths.begin() + static_cast<std::ptrdiff_t>(strengths.size() / 2);
  std::nth_element(strengths.begin(), middle, strengths.end());
  return std::max(0.002, *middle / 1.1774);
}

UncertainSegment2 regression_line(std::span<const Eigen::Vector2d> points, double pooled_px) {
  const PrincipalAxes axes = principal_axes(points);
  const double n = static_cast<double>(points.size());
  const double first = axes.along.dot(points.front() - axes.centroid);
  const double last = axes.along.dot(points.back() - axes.centroid);
  constexpr double kPrior = 20.0;
  const double variance =
      (n * axes.lambda_min + kPrior * pooled_px * pooled_px) / (n - 2.0 + kPrior);
  const double n_effective = std::max(2.0, n / 3.0);
  UncertainSegment2 line;
  line.segment = {axes.centroid + first * axes.along, axes.centroid + last * axes.along};
  line.centroid_px = axes.centroid;
  line.sigma_q_px = std::sqrt(variance / n_effective + 0.02 * 0.02);
  line.sigma_phi_rad =
      std::sqrt(12.0 * variance / (n_effective * std::pow(last - first, 2)) + 1e-8);
  line.sigma_e_px = 1.0;
  return line;
}

Segment2 reversed(const Segment2& s) { return {s.end, s.start}; }

}  // namespace

std::vector<EdgeSegment> extract_segments(const cv::Mat& image,
                                          const PixelMap& ideal_from_image,
                                          const ExtractOptions& options) {
  check(!image.empty() && image.depth() == CV_32F && image.channels() <= 4,
        "extract_segments: the image must have 1 to 4 bands of float");
  validate(options);
  const cv::Mat gradient = colour_gradient(image, options.gradient_sigma_px);
  const double noise = gradient_noise(gradient);
  const std::vector<EdgePixel> pixels =
      edge_pixels(gradient, static_cast<float>(options.low_noise_factor * noise));
  const cv::Mat index = edge_pixel_index(pixels, image.size());
  const double high = options.high_noise_factor * noise;
  std::vector<EdgeSegment> segments;
  for (const Chain& chain : linked_chains(pixels, index)) {
    float strongest = 0.0F;
    std::vector<Eigen::Vector2d> points;
    for (const int i : chain) {
      strongest = std::max(strongest, pixels[i].gradient.norm());
      points.push_back(pixels[i].position_px.cast<double>());
    }
    if (strongest < high) continue;
    for (const Piece& piece : straight_pieces(points, options)) {
      const auto run = std::span(points).subspan(piece.first, piece.last - piece.first);
      EdgeSegment segment;
      segment.line = regression_line(run, 0.1);
      segment.in_image = segment.line.segment;
      if (ideal_from_image) {
        std::vector<Eigen::Vector2d> ideal;
        for (const Eigen::Vector2d& x : run) {
          if (const auto mapped = ideal_from_image(x)) ideal.push_back(*mapped);
        }
        if (ideal.size() < run.size()) continue;
        segment.line = regression_line(ideal, 0.1);
      }
      segment.n_edge_pixels = static_cast<int>(run.size());
      segment.rms_px = std::sqrt(principal_axes(run).lambda_min);
      double sum = 0.0;
      for (int i = piece.first; i < piece.last; ++i) sum += pixels[chain[i]].gradient.norm();
      segment.contrast = sum / static_cast<double>(run.size());
      std::tie(segment.left, segment.right) = [&] {
        const auto both = flanks(image, segment.in_image);
        return std::pair(both[0], both[1]);
      }();
      if (segment.left.grey > segment.right.grey) {
        std::swap(segment.left, segment.right);
        segment.in_image = reversed(segment.in_image);
        segment.line.segment = reversed(segment.line.segment);
      }
      segments.push_back(segment);
    }
  }
  return segments;
}

const char* name(Detector detector) {
  switch (detector) {
    case Detector::kOurs:
      return "ours";
    case Detector::kEdgeDrawing:
      return "edge_drawing";
    default:
      return "lsd";
  }
}

}  // namespace ridgeline::reconstruct
