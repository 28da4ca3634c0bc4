// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/appearance/colour_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ridgeline::reconstruct {
namespace {

constexpr double kEndMargin_px = 1.5;
constexpr double kBin_px = 0.1;

Eigen::Index n_bins(double half_width_px) {
  return static_cast<Eigen::Index>(std::lround(2.0 * half_width_px / kBin_px));
}

Eigen::Vector4d colour_at(const cv::Mat& image, int x, int y) {
  Eigen::Vector4d colour = Eigen::Vector4d::Zero();
  const auto* pixel = image.ptr<float>(y) + static_cast<std::ptrdiff_t>(x) * image.channels();
  for (int band = 0; band < image.channels(); ++band) colour[band] = pixel[band];
  return colour;
}

}  // namespace

double profile_half_width_px(double blur_px) { return 2.0 + 2.75 * blur_px; }

std::vector<ProfileSample> profile_samples(const cv::Mat& image,
                                           const Segment2& segment,
                                           double half_width,
                                           double unit_px) {
  const double half_width_px = half_width * unit_px;
  const double len = length(segment);
  if (!(len > 2.0 * kEndMargin_px)) return {};
  const Eigen::Vector2d along = (segment.end - segment.start) / len;
  const Eigen::Vector2d normal(-along.y(), along.x());
  const int major = std::abs(along.x()) >= std::abs(along.y()) ? 0 : 1;
  const int minor = 1 - major;
  const std::array<int, 2> size{image.cols, image.rows};
  const double reach = half_width_px / std::abs(along[major]);
  const auto [low, high] = std::minmax(segment.start[major], segment.end[major]);
  const int first = std::max(0, static_cast<int>(std::floor(low - half_width_px)));
  const int last = std::min(size[major] - 1, static_cast<int>(std::ceil(high + half_width_px)));
  std::vector<ProfileSample> samples;
  samples.reserve(static_cast<std::size_t>(2.0 * reach + 2.0) *
                  static_cast<std::size_t>(std::max(0, last - first + 1)));
  for (int i = first; i <= last; ++i) {
    const double centre =
        segment.start[minor] + (i - segment.start[major]) * along[minor] / along[major];
    const int from = std::max(0, static_cast<int>(std::ceil(centre - reach)));
    const int to = std::min(size[minor] - 1, static_cast<int>(std::floor(centre + reach)));
    for (int k = from; k <= to; ++k) {
      const Eigen::Vector2i pixel = major == 0 ? Eigen::Vector2i(i, k) : Eigen::Vector2i(k, i);
      const Eigen::Vector2d x = pixel.cast<double>() - segment.start;
      const double t = along.dot(x);
      if (t < kEndMargin_px || t > len - kEndMargin_px) continue;
      samples.push_back(
          {normal.dot(x) / unit_px, 2.0 * t / len - 1.0, colour_at(image, pixel.x(), pixel.y())});
    }
  }
  return samples;
}

double step_response(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

StepBasis::StepBasis(double half_width_px, double largest_offset_px, double blur_px) {
  const auto n = static_cast<Eigen::Index>(std::lround(2.0 * largest_offset_px / kBin_px)) + 1;
  offsets_px = Eigen::VectorXd::LinSpaced(n, -largest_offset_px, largest_offset_px);
  responses.resize(n, n_bins(half_width_px));
  for (Eigen::Index k = 0; k < responses.cols(); ++k) {
    const double s = -half_width_px + kBin_px * (static_cast<double>(k) + 0.5);
    for (Eigen::Index i = 0; i < n; ++i) {
      responses(i, k) = step_response((s - offsets_px[i]) / blur_px);
    }
  }
}

BinnedProfile::BinnedProfile(std::span<const ProfileSample> samples, double half_width_px) {
  const Eigen::Index n = n_bins(half_width_px);
  counts.setZero(n);
  sums.setZero(n, 4);
  for (const ProfileSample& s : samples) {
    const auto bin = static_cast<Eigen::Index>((s.across + half_width_px) / kBin_px);
    const Eigen::Index inside = std::clamp(bin, Eigen::Index{0}, n - 1);
    counts[inside] += 1.0;
    sums.row(inside) += s.colour.transpose();
    squares += s.colour.squaredNorm();
  }
  squares -= sums.colwise().sum().squaredNorm() / counts.sum();
}

StepEquations::StepEquations(const StepBasis& basis, const BinnedProfile& profile) {
  const Eigen::MatrixXd weighted = basis.responses * profile.counts.asDiagonal();
  const Eigen::VectorXd sums = weighted.rowwise().sum();
  const double n = profile.counts.sum();
  normal = weighted * basis.responses.transpose() - sums * sums.transpose() / n;
  right = basis.responses * profile.sums - sums * profile.sums.colwise().sum() / n;
}

double StepEquations::gain(Eigen::Index i, Eigen::Index j) const {
  const double a = normal(i, i);
  const double b = normal(j, j);
  const double c = normal(i, j);
  const double determinant = a * b - c * c;
  if (!(determinant > 1e-9 * a * b)) return 0.0;
  return (b * right.row(i).squaredNorm() - 2.0 * c * right.row(i).dot(right.row(j)) +
          a * right.row(j).squaredNorm()) /
         determinant;
}

double best_gain(const StepBasis& basis, const BinnedProfile& profile) {
  const Eigen::MatrixXd weighted = basis.responses * profile.counts.asDiagonal();
  const Eigen::VectorXd sums = weighted.rowwise().sum();
  const double n = profile.counts.sum();
  const Eigen::VectorXd normal =
      weighted.cwiseProduct(basis.responses).rowwise().sum() - sums.cwiseAbs2() / n;
  const Eigen::MatrixX4d right =
      basis.responses * profile.sums - sums * profile.sums.colwise().sum() / n;
  return (right.rowwise().squaredNorm().array() / normal.array().max(1e-9)).maxCoeff();
}

}  // namespace ridgeline::reconstruct
