// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/guided_matches/step_along.h"

#include "reconstruct/geometry/parabola.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

constexpr double kOffsetStep_px = 0.25;  // spacing of the offsets across the line
constexpr int kMaxOffsetSteps = 8;       // in offset steps: 2 px
constexpr int kReach = 10;               // reach of the derivative, in offset steps
constexpr double kSmoothing_px = 0.8;
constexpr double kExpected_px = 0.5;      // sigma of the position of a line predicted by a surface
constexpr double kMinSignificance = 3.5;  // in standard deviations
constexpr double kTogether_px = 2.8;      // pixels along a line with a common error
constexpr int kWindow_px = 2;             // pixels along the line, in both directions
constexpr int kStray = 4;                 // largest offset from the mean line, in steps: 1 px
constexpr double kMinStrength = 0.5;      // share of the mean step
constexpr double kMinTraceFill = 0.75;    // share of the line
constexpr std::size_t kMinTraceLength_px = 10;

constexpr int kOffsets = 2 * kMaxOffsetSteps + 1;
constexpr int kSamples = kOffsets + 2 * kReach;

/// Gradient across the line, per band and offset.
using Gradients = Eigen::Matrix<double, kMaxBands, kOffsets>;

/// Matrix of Gaussian derivatives of samples across the line.
Eigen::Matrix<double, kSamples, kOffsets> derivative() {
  Eigen::Matrix<double, kSamples, kOffsets> by = Eigen::Matrix<double, kSamples, kOffsets>::Zero();
  Eigen::Matrix<double, 2 * kReach + 1, 1> weights;
  double of_ramp = 0.0;
  for (int i = 0; i < weights.size(); ++i) {
    const double x_px = (i - kReach) * kOffsetStep_px;
    weights[i] = x_px * std::exp(-0.5 * std::pow(x_px / kSmoothing_px, 2.0));
    of_ramp += weights[i] * x_px;
  }
  for (int offset = 0; offset < kOffsets; ++offset) {
    by.col(offset).segment<2 * kReach + 1>(offset) = weights / of_ramp;
  }
  return by;
}

/// The gradients at every pixel along a line that lies inside the image.
struct LineGradients {
  std::vector<double> t_px;
  std::vector<Gradients> across;
};

LineGradients gradients_along(const ImageSampler& image, const Segment2& line) {
  static const auto by_samples = derivative();
  const Eigen::Vector2d u = along(line);
  const Eigen::Vector2d n = normal_of(u);
  LineGradients found;
  for (int t = 0; t <= static_cast<int>(length(line)); ++t) {
    Eigen::Matrix<double, kMaxBands, kSamples> colours;
    bool is_inside = true;
    for (int i = 0; i < kSamples && is_inside; ++i) {
      Colour colour{};
      is_inside = image.sample(
          line.start + t * u + (i - kMaxOffsetSteps - kReach) * kOffsetStep_px * n, colour);
      for (int band = 0; band < kMaxBands; ++band)
        colours(band, i) = double{colour[static_cast<std::size_t>(band)]};
    }
    if (!is_inside) continue;
    found.t_px.push_back(t);
    found.across.push_back(colours * by_samples);
  }
  return found;
}

bool is_peak(const Eigen::Matrix<double, 1, kOffsets>& values, int i) {
  return i > 0 && i + 1 < kOffsets && values[i] >= values[i - 1] && values[i] > values[i + 1];
}

/// The offset of the step at the expected line; empty if there is none.
std::optional<int> expected_step(const LineGradients& line, const Gradients& mean) {
  const auto n = static_cast<double>(line.across.size());
  Eigen::Matrix<double, 1, kOffsets> squares = Eigen::Matrix<double, 1, kOffsets>::Zero();
  for (const Gradients& g : line.across) squares += (g - mean).colwise().squaredNorm();
  const Eigen::Matrix<double, 1, kOffsets> strength = mean.colwise().norm();
  std::optional<int> best;
  double most = 0.0;
  for (int i = 0; i < kOffsets; ++i) {
    if (!is_peak(strength, i)) continue;
    const double significance =
        strength[i] / std::sqrt(squares[i] * kTogether_px / (n * n) + 1e-12);
    if (significance < kMinSignificance) continue;
    const double off_px = (i - kMaxOffsetSteps) * kOffsetStep_px;
    const double score = significance * std::exp(-0.5 * std::pow(off_px / kExpected_px, 2.0));
    if (score <= most) continue;
    most = score;
    best = i;
  }
  return best;
}

/// The sufficiently strong peak nearest to an offset.
std::optional<int> nearest_peak(const Eigen::Matrix<double, 1, kOffsets>& strength,
                                int at,
                                double least) {
  std::optional<int> nearest;
  for (int i = std::max(0, at - kStray); i <= std::min(kOffsets - 1, at + kStray); ++i) {
    if (!is_peak(strength, i) || strength[i] < least) continue;
    if (!nearest || std::abs(i - at) < std::abs(*nearest - at)) nearest = i;
  }
  return nearest;
}

}  // namespace

std::optional<EdgeTrace> step_along(const ImageSampler& image, const Segment2& expected) {
  const LineGradients line = gradients_along(image, expected);
  const auto n = static_cast<int>(line.across.size());
  if (line.across.size() < kMinTraceLength_px) return std::nullopt;
  Gradients mean = Gradients::Zero();
  for (const Gradients& g : line.across) mean += g / n;
  const auto at = expected_step(line, mean);
  if (!at) return std::nullopt;
  const Eigen::Matrix<double, 1, kMaxBands> colour = mean.col(*at).normalized().transpose();
  const double least = kMinStrength * mean.col(*at).norm();
  const Eigen::Vector2d u = along(expected);
  const bool is_steep = std::abs(u.y()) > std::abs(u.x());
  EdgeTrace trace;
  for (int i = 0; i < n; ++i) {
    const int first = std::max(0, i - kWindow_px);
    const int last = std::min(n - 1, i + kWindow_px);
    Gradients sum = Gradients::Zero();
    for (int k = first; k <= last; ++k) sum += line.across[static_cast<std::size_t>(k)];
    const Eigen::Matrix<double, 1, kOffsets> strength = colour * sum / (last - first + 1);
    const auto peak = nearest_peak(strength, *at, least);
    if (!peak) continue;
    const double offset_px =
        kOffsetStep_px *
        (*peak - kMaxOffsetSteps +
         vertex_of_parabola(strength[*peak - 1], strength[*peak], strength[*peak + 1]));
    const Eigen::Vector2d x =
        expected.start + line.t_px[static_cast<std::size_t>(i)] * u + offset_px * normal_of(u);
    trace.push_back({x, strength[*peak], static_cast<int>(std::lround(is_steep ? x.y() : x.x()))});
  }
  if (trace.size() < kMinTraceLength_px || static_cast<double>(trace.size()) < kMinTraceFill * n)
    return std::nullopt;
  return trace;
}

}  // namespace ridgeline::reconstruct
