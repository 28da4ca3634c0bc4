// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/regression_line.h"

#include "reconstruct/geometry/check.h"

#include <Eigen/Eigenvalues>

namespace ridgeline::reconstruct {
namespace {

constexpr int kIterations = 3;
constexpr std::size_t kTrimmed = 2;          ///< points at each end
constexpr std::size_t kMinForTrimming = 12;  ///< points
constexpr double kHuber = 1.345;
constexpr double kSigmaOfMedian = 1.4826;
constexpr double kSmallestSigma_px = 0.02;

double median_absolute(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  for (double& value : values) value = std::abs(value);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool at_end(std::size_t i, std::size_t n) {
  return n >= kMinForTrimming && (i < kTrimmed || i + kTrimmed >= n);
}

void fit(std::span<const Eigen::Vector2d> points, RegressionLine& line) {
  line.centroid.setZero();
  line.sum_weights = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    line.centroid += line.weight[i] * points[i];
    line.sum_weights += line.weight[i];
  }
  line.centroid /= line.sum_weights;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d x = points[i] - line.centroid;
    scatter += line.weight[i] * x * x.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(scatter);
  line.along = solver.eigenvectors().col(1).normalized();
  if (line.along.dot(points.back() - points.front()) < 0.0) line.along = -line.along;
  line.sum_weights_t2 = solver.eigenvalues()[1];
  const Eigen::Vector2d normal(-line.along.y(), line.along.x());
  for (std::size_t i = 0; i < points.size(); ++i) {
    line.residual_px[i] = normal.dot(points[i] - line.centroid);
  }
}

}  // namespace

RegressionLine regression_line(std::span<const Eigen::Vector2d> points) {
  const std::size_t n = points.size();
  check(n >= 3, "regression_line: ", n, " points, must be at least 3");
  RegressionLine line;
  line.residual_px.resize(n);
  line.weight.resize(n);
  for (std::size_t i = 0; i < n; ++i) line.weight[i] = at_end(i, n) ? 0.0 : 1.0;
  fit(points, line);
  for (int k = 0; k < kIterations; ++k) {
    const double sigma =
        std::max(kSmallestSigma_px, kSigmaOfMedian * median_absolute(line.residual_px));
    for (std::size_t i = 0; i < n; ++i) {
      const double ratio = std::abs(line.residual_px[i]) / (kHuber * sigma);
      line.weight[i] = at_end(i, n) ? 0.0 : 1.0 / std::max(1.0, ratio);
    }
    fit(points, line);
  }
  line.first = line.along.dot(points.front() - line.centroid);
  line.last = line.along.dot(points.back() - line.centroid);
  return line;
}

namespace {

constexpr std::size_t kMinForStatistics = 30;
constexpr int kMaxLag = 8;
constexpr double kTypicalCorrelation = 2.5;
constexpr double kShrinkage = 10.0;
constexpr double kSystematicAcross_px = 0.01;
constexpr double kSigmaAlong_px = 1.0;

}  // namespace

double variance_px2(const RegressionLine& line) {
  double sum = 0.0;
  for (std::size_t i = 0; i < line.weight.size(); ++i) {
    sum += line.weight[i] * line.residual_px[i] * line.residual_px[i];
  }
  return sum / std::max(1.0, line.sum_weights - 2.0);
}

EdgeNoise edge_noise(std::span<const RegressionLine> lines) {
  std::vector<double> variances;
  std::array<double, kMaxLag + 1> products{};
  std::array<double, kMaxLag + 1> counts{};
  for (const RegressionLine& line : lines) {
    const std::size_t n = line.weight.size();
    if (n < kMinForStatistics) continue;
    const double variance = std::max(1e-8, variance_px2(line));
    variances.push_back(variance);
    for (int lag = 0; lag <= kMaxLag; ++lag) {
      for (std::size_t i = 0; i + lag < n; ++i) {
        const double w = line.weight[i] * line.weight[i + lag];
        products[lag] += w * line.residual_px[i] * line.residual_px[i + lag] / variance;
        counts[lag] += w;
      }
    }
  }
  EdgeNoise noise;
  noise.correlation = kTypicalCorrelation;
  if (variances.empty()) return noise;
  const auto middle = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 2);
  std::nth_element(variances.begin(), middle, variances.end());
  noise.variance_px2 = *middle;
  noise.correlation = 1.0;
  for (int lag = 1; lag <= kMaxLag; ++lag) {
    noise.correlation += 2.0 * products[lag] / counts[lag] / (products[0] / counts[0]);
  }
  noise.correlation = std::clamp(noise.correlation, 1.0, 10.0);
  return noise;
}

UncertainSegment2 uncertain_segment(const RegressionLine& line, const EdgeNoise& noise) {
  const double freedom = std::max(1.0, line.sum_weights - 2.0);
  const double own = variance_px2(line) * freedom / noise.correlation;
  const double variance = (own + kShrinkage * noise.variance_px2) /
                          (freedom / noise.correlation + kShrinkage) * noise.correlation;
  const double half_length = 0.5 * (line.last - line.first);
  UncertainSegment2 segment;
  segment.segment = {line.centroid + line.first * line.along,
                     line.centroid + line.last * line.along};
  segment.centroid_px = line.centroid;
  segment.sigma_q_px = std::hypot(std::sqrt(variance / line.sum_weights), kSystematicAcross_px);
  segment.sigma_phi_rad =
      std::hypot(std::sqrt(variance / line.sum_weights_t2), kSystematicAcross_px / half_length);
  segment.sigma_e_px = kSigmaAlong_px;
  return segment;
}

}  // namespace ridgeline::reconstruct
