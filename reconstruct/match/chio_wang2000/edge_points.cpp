// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/edge_points.h"

#include "reconstruct/geometry/parabola.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace ridgeline::reconstruct {
namespace {

constexpr double kStep_px = 0.5;    // step of the profile across the edge
constexpr int kHalfDifference = 2;  // the gradient is taken between samples 2 px apart
constexpr int kSearchReach = 3;     // maxima up to 1.5 px from the segment count
constexpr int kHalfBase = 2;        // the parabola through a maximum spans 2 px
constexpr int kHalfGradients = kSearchReach + kHalfBase;
constexpr int kGradients = 2 * kHalfGradients + 1;
constexpr int kHalfProfile = kHalfGradients + kHalfDifference;
constexpr int kProfileBins = 2 * kHalfProfile + 1;

/// Squared difference of two colours.
double difference(const Colour& a, const Colour& b) {
  double sum = 0.0;
  for (std::size_t band = 0; band < a.size(); ++band) {
    const double d = static_cast<double>(a[band]) - static_cast<double>(b[band]);
    sum += d * d;
  }
  return sum;
}

/// Offset along the unit normal from x to the strongest gradient. It is the vertex of the parabola
/// through the logarithms of the gradients, which is exact for a blurred step.
std::optional<double> edge_offset_px(const ImageSampler& image,
                                     const Eigen::Vector2d& x,
                                     const Eigen::Vector2d& normal) {
  std::array<Colour, kProfileBins> profile{};
  for (int k = 0; k < kProfileBins; ++k) {
    const double offset_px = (k - kHalfProfile) * kStep_px;
    if (!image.sample(x + offset_px * normal, profile[k])) return std::nullopt;
  }
  std::array<double, kGradients> strength{};
  int best = kHalfGradients;
  for (int k = 0; k < kGradients; ++k) {
    strength[k] = difference(profile[k + 2 * kHalfDifference], profile[k]);
    const bool in_reach = std::abs(k - kHalfGradients) <= kSearchReach;
    if (in_reach && strength[k] > strength[best]) best = k;
  }
  const double before = strength[best - kHalfBase];
  const double after = strength[best + kHalfBase];
  if (!(before > 0.0 && after > 0.0 && std::max(before, after) < strength[best])) {
    return std::nullopt;
  }
  const double peak =
      vertex_of_parabola(std::log(before), std::log(strength[best]), std::log(after));
  return (best - kHalfGradients + kHalfBase * peak) * kStep_px;
}

}  // namespace

std::vector<EdgePoint> edge_points(const ImageSampler& image, const EdgeSegment& edge) {
  const int n_steps = std::max(1, static_cast<int>(length(edge.line.segment)));
  const Eigen::Vector2d in_image = normal(edge.in_image);
  const Eigen::Vector2d ideal = normal(edge.line.segment);
  std::vector<EdgePoint> points;
  points.reserve(static_cast<std::size_t>(n_steps));
  for (int step = 0; step < n_steps; ++step) {
    const double t = (step + 0.5) / n_steps;
    const auto offset_px = edge_offset_px(image, point_at(edge.in_image, t), in_image);
    if (!offset_px) continue;
    // the lens distortion is constant over a pixel
    points.push_back({step, point_at(edge.line.segment, t) + *offset_px * ideal});
  }
  return points;
}

}  // namespace ridgeline::reconstruct
