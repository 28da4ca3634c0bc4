// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/border_line.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace ridgeline::evaluate {
namespace {

constexpr double kOutlierShare = 0.01;
constexpr double kMaxSlope = 0.27;    // 15 degrees
constexpr double kUsualShare = 0.95;  ///< of the borders with the usual slope
constexpr int kSlopeSteps = 41, kOffsetSteps = 48;

/// Distances t of the points from the line through the middle with a slope, the outermost first.
std::vector<double> distances_m(const BorderPoints& points, double slope) {
  std::vector<double> t;
  t.reserve(points.st_m.size());
  for (const Eigen::Vector2d& x : points.st_m)
    t.push_back(x.y() - slope * (x.x() - 0.5 * points.length_m));
  std::ranges::sort(t, std::greater<>());
  return t;
}

/// The mean distance from a random place to the next point inwards, from the gaps between points:
/// sum of squares / (2 sum). It is 1 / density for random points and half the distance of scan
/// lines that run along the border.
double mean_gap_m(std::span<const double> t) {
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    const double gap_m = t[i] - t[i + 1];
    sum += gap_m;
    squares += gap_m * gap_m;
  }
  return sum > 0.0 ? squares / (2.0 * sum) : 0.0;
}

double log_prior(const BorderPoints& points, double slope) {
  double density = (1.0 - kUsualShare) / (2.0 * kMaxSlope);
  if (std::isfinite(points.usual_slope)) {
    const double z = (slope - points.usual_slope) / points.usual_slope_sigma;
    density += kUsualShare * std::exp(-0.5 * z * z) /
               (points.usual_slope_sigma * std::sqrt(2.0 * std::numbers::pi));
  }
  return std::log(density);
}

/// Log likelihood of a border at `offset_m` with the area behind it covered evenly.
double log_likelihood(std::span<const double> t, double offset_m, double sigma_m, double gap_m) {
  constexpr double kReach = 5.0;
  double sum = -offset_m / gap_m;
  for (const double x : t) {
    const double z = (offset_m - x) / sigma_m;
    if (z > kReach) break;  // t is sorted: all others lie further inside
    sum +=
        std::log((1.0 - kOutlierShare) * 0.5 * std::erfc(-z / std::numbers::sqrt2) + kOutlierShare);
  }
  return sum;
}

struct Node {
  double offset_m, slope, log_density;
};

/// Slopes to integrate over: an even grid, and a fine one at the usual slope.
std::vector<std::pair<double, double>> slopes_and_weights(const BorderPoints& points) {
  std::vector<double> slopes;
  slopes.reserve(kSlopeSteps);
  for (int i = 0; i < kSlopeSteps; ++i)
    slopes.push_back(kMaxSlope * (2.0 * i / (kSlopeSteps - 1.0) - 1.0));
  if (std::isfinite(points.usual_slope)) {
    constexpr int kFine = 13;
    for (int i = 0; i < kFine; ++i)
      slopes.push_back(points.usual_slope +
                       points.usual_slope_sigma * 3.0 * (2.0 * i / (kFine - 1.0) - 1.0));
  }
  std::ranges::sort(slopes);
  std::vector<std::pair<double, double>> nodes;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const double before = i == 0 ? slopes[i] : slopes[i - 1];
    const double after = i + 1 == slopes.size() ? slopes[i] : slopes[i + 1];
    nodes.emplace_back(slopes[i], 0.5 * (after - before));
  }
  return nodes;
}

}  // namespace

BorderLine border_line(const BorderPoints& points) {
  const double sigma_m = std::max(points.sigma_m, 1e-4);
  const double first_slope = std::isfinite(points.usual_slope) ? points.usual_slope : 0.0;
  const double gap_m = std::max(mean_gap_m(distances_m(points, first_slope)), 0.2 * sigma_m);
  std::vector<Node> nodes;
  for (const auto& [slope, weight] : slopes_and_weights(points)) {
    if (!(weight > 0.0)) continue;
    const std::vector<double> t = distances_m(points, slope);
    // from the third point inwards, so that two outliers may be left outside
    const double low = t[std::min<std::size_t>(2, t.size() - 1)] - 3.0 * sigma_m;
    const double high = t.front() + 3.0 * sigma_m + 8.0 * gap_m;
    const double step = (high - low) / kOffsetSteps;
    const double log_weight = std::log(weight * step) + log_prior(points, slope);
    for (int i = 0; i < kOffsetSteps; ++i) {
      const double offset_m = low + (i + 0.5) * step;
      nodes.push_back({offset_m, slope, log_weight + log_likelihood(t, offset_m, sigma_m, gap_m)});
    }
  }
  const double highest = std::ranges::max_element(nodes, {}, &Node::log_density)->log_density;
  double sum = 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (Node& node : nodes) {
    node.log_density = std::exp(node.log_density - highest);
    sum += node.log_density;
    mean += node.log_density * Eigen::Vector2d(node.offset_m, node.slope);
  }
  mean /= sum;
  BorderLine line{.offset_m = mean.x(), .slope = mean.y()};
  for (const Node& node : nodes) {
    const Eigen::Vector2d d = Eigen::Vector2d(node.offset_m, node.slope) - mean;
    line.covariance += node.log_density / sum * d * d.transpose();
  }
  line.moved_out_m = line.offset_m - distances_m(points, line.slope).front();
  return line;
}

}  // namespace ridgeline::evaluate
