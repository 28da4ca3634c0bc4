// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/regression_line.h"

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/median.h"

#include <Eigen/Eigenvalues>

namespace ridgeline::reconstruct {
namespace {

constexpr int kIterations = 3;
constexpr std::size_t kTrimmed = 2;          ///< number of points at each end
constexpr std::size_t kMinForTrimming = 12;  ///< minimum number of points
constexpr double kHuber = 1.345;
constexpr double kSigmaOfMedian = 1.4826;
constexpr double kMinLineSigma_px = 0.02;

double median_absolute(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return upper_median(std::move(values));
}

bool at_end(std::size_t i, std::size_t n) {
  return n >= kMinForTrimming && (i < kTrimmed || i + kTrimmed >= n);
}

/// Weighted sum of the squared residuals.
double squares(const RegressionLine& line) {
  double sum = 0.0;
  for (std::size_t i = 0; i < line.weight.size(); ++i) {
    sum += line.weight[i] * line.residual_px[i] * line.residual_px[i];
  }
  return sum;
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
        std::max(kMinLineSigma_px, kSigmaOfMedian * median_absolute(line.residual_px));
    for (std::size_t i = 0; i < n; ++i) {
      const double ratio = std::abs(line.residual_px[i]) / (kHuber * sigma);
      line.weight[i] = at_end(i, n) ? 0.0 : 1.0 / std::max(1.0, ratio);
    }
    fit(points, line);
  }
  line.rms_px = std::sqrt(squares(line) / line.sum_weights);
  line.first = line.along.dot(points.front() - line.centroid);
  line.last = line.along.dot(points.back() - line.centroid);
  return line;
}

namespace {

constexpr std::size_t kMinForStatistics = 30;
constexpr int kMaxLag = 4;
constexpr double kShrinkage = 10.0;
/// Lower bound on the noise of a point. Edges of a drawing may fit their lines exactly, but no line
/// is known exactly.
constexpr double kExact_px = 1e-3;
constexpr double kSigmaAlong_px = 1.0;

/// The two parameters of the line use up two independent points, each of which corresponds to
/// `correlation` points.
double degrees_of_freedom(const RegressionLine& line, double correlation) {
  return std::max(1.0, line.sum_weights - 2.0 * correlation);
}

/// Autocorrelation of the residuals of lines, each line scaled to variance 1.
struct Autocorrelation {
  std::array<double, kMaxLag + 1> products{}, counts{};
  double n_points = 0.0;
  int n_lines = 0;

  void add(const RegressionLine& line) {
    const double variance = std::max(1e-8, variance_px2(line, 1.0));
    const std::size_t n = line.weight.size();
    for (std::size_t lag = 0; lag < products.size(); ++lag) {
      for (std::size_t i = 0; i + lag < n; ++i) {
        const double w = line.weight[i] * line.weight[i + lag];
        products[lag] += w * line.residual_px[i] * line.residual_px[i + lag] / variance;
        counts[lag] += w;
      }
    }
    n_points += line.sum_weights;
    ++n_lines;
  }

  /// The factor f = 1 + 2 sum rho_k. The residuals of a line through n points with two parameters
  /// have on average the correlations r_k = (rho_k - 2 f / n) / (1 - 2 f / n); these equations are
  /// solved for f.
  [[nodiscard]] double inflation() const {
    if (!(products[0] > 0.0)) return 1.0;  // all lines fit exactly
    double sum = 0.0;
    for (int lag = 1; lag <= kMaxLag; ++lag) {
      sum += products[lag] / counts[lag] / (products[0] / counts[0]);
    }
    const double mean_n = n_points / n_lines;
    return std::clamp((1.0 + 2.0 * sum) / (1.0 - 4.0 * (kMaxLag - sum) / mean_n), 1.0, 10.0);
  }
};

}  // namespace

double variance_px2(const RegressionLine& line, double correlation) {
  return squares(line) / degrees_of_freedom(line, correlation);
}

EdgeNoise edge_noise(std::span<const RegressionLine> lines) {
  Autocorrelation autocorrelation;
  for (const RegressionLine& line : lines) {
    if (line.weight.size() >= kMinForStatistics) autocorrelation.add(line);
  }
  EdgeNoise noise;
  if (autocorrelation.n_lines == 0) return noise;
  noise.correlation = autocorrelation.inflation();
  std::vector<double> variances;
  for (const RegressionLine& line : lines) {
    if (line.weight.size() < kMinForStatistics) continue;
    variances.push_back(variance_px2(line, noise.correlation));
  }
  noise.variance_px2 = upper_median(std::move(variances));
  return noise;
}

UncertainSegment2 uncertain_segment(const RegressionLine& line,
                                    const EdgeNoise& noise,
                                    const SystematicError& systematic) {
  const double own_weight = degrees_of_freedom(line, noise.correlation) / noise.correlation;
  const double own = variance_px2(line, noise.correlation);
  const double mean =
      std::max(kExact_px * kExact_px, (own_weight * own + kShrinkage * noise.variance_px2) /
                                          (own_weight + kShrinkage) * noise.correlation);
  const double half_length = 0.5 * (line.last - line.first);
  UncertainSegment2 segment;
  segment.segment = {line.centroid + line.first * line.along,
                     line.centroid + line.last * line.along};
  segment.centroid_px = line.centroid;
  segment.sigma_q_px = std::hypot(std::sqrt(mean / line.sum_weights), systematic.across_px);
  segment.sigma_phi_rad =
      std::hypot(std::sqrt(mean / line.sum_weights_t2), systematic.ends_px / half_length);
  segment.sigma_e_px = kSigmaAlong_px;
  return segment;
}

}  // namespace ridgeline::reconstruct
