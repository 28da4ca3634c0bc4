// SPDX-License-Identifier: BSD-3-Clause
// The constraints on the image content of a pair: correlation and spatiogram.
#include "reconstruct/match/ok2011/constraints.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr int kNumBins = 8;
/// Variance of the grey values below which a patch has no texture to compare.
constexpr double kMinVariance = 1e-6;

Eigen::Vector2d place(int sample) { return {sample % PairPatch::kSize, sample / PairPatch::kSize}; }

/// A bin of a spatiogram: share of the pixels, mean and covariance of their positions, in grid
/// units.
struct Bin {
  double share = 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d cov = Eigen::Matrix2d::Zero();
};
using Spatiogram = std::array<Bin, kNumBins>;

Spatiogram spatiogram(const PairPatch& patch, int band, float low, float high) {
  Spatiogram bins{};
  std::array<Eigen::Matrix2d, kNumBins> squares;
  squares.fill(Eigen::Matrix2d::Zero());
  for (int sample = 0; sample < PairPatch::kNumSamples; ++sample) {
    const float position = (patch.colours[sample][band] - low) / (high - low);
    const int bin = std::clamp(static_cast<int>(position * kNumBins), 0, kNumBins - 1);
    const Eigen::Vector2d x = place(sample);
    bins[bin].share += 1.0;
    bins[bin].mean += x;
    squares[bin] += x * x.transpose();
  }
  for (int b = 0; b < kNumBins; ++b) {
    Bin& bin = bins[b];
    if (!(bin.share > 0.0)) continue;
    bin.mean /= bin.share;
    // The added variance of one grid cell keeps the covariance of bins with few pixels regular.
    bin.cov =
        squares[b] / bin.share - bin.mean * bin.mean.transpose() + Eigen::Matrix2d::Identity();
    bin.share /= PairPatch::kNumSamples;
  }
  return bins;
}

/// Similarity of two bins, sqrt(n n') 8 pi |S S'|^(1/4) N(mu; mu', 2 (S + S')), O Conaire et al.
/// 2007, Eq. 9.
double bin_similarity(const Bin& a, const Bin& b) {
  if (!(a.share > 0.0 && b.share > 0.0)) return 0.0;
  const Eigen::Matrix2d sum = 2.0 * (a.cov + b.cov);
  const Eigen::Vector2d d = a.mean - b.mean;
  const double determinant = sum.determinant();
  const double density =
      std::exp(-0.5 * d.dot(sum.inverse() * d)) / (2.0 * M_PI * std::sqrt(determinant));
  return std::sqrt(a.share * b.share) * 8.0 * M_PI *
         std::pow(a.cov.determinant() * b.cov.determinant(), 0.25) * density;
}

}  // namespace

std::optional<PairPatch> pair_patch(const ImageSampler& image, const PairFrame& frame) {
  PairPatch patch;
  patch.n_bands = image.n_bands();
  int sample = 0;
  for (int row = 0; row < PairPatch::kSize; ++row) {
    const Eigen::Vector2d start = frame.origin + (row + 0.5) / PairPatch::kSize * frame.second;
    for (int column = 0; column < PairPatch::kSize; ++column) {
      const Eigen::Vector2d x = start + (column + 0.5) / PairPatch::kSize * frame.first;
      if (!image.sample(x, patch.colours[sample++])) return std::nullopt;
    }
  }
  return patch;
}

std::optional<double> correlation(const PairPatch& left, const PairPatch& right) {
  std::array<BandSums, kMaxBands> sums{};
  double variance_left = 0.0;
  double variance_right = 0.0;
  for (int band = 0; band < left.n_bands; ++band) {
    BandSums& s = sums[band];
    for (int i = 0; i < PairPatch::kNumSamples; ++i) {
      s.add(left.colours[i][band], right.colours[i][band]);
    }
    constexpr double kN = PairPatch::kNumSamples;
    variance_left += s.aa / kN - s.a * s.a / (kN * kN);
    variance_right += s.bb / kN - s.b * s.b / (kN * kN);
  }
  const double least = kMinVariance * left.n_bands;
  if (!(variance_left > least && variance_right > least)) return std::nullopt;
  return std::clamp(correlation(sums, PairPatch::kNumSamples), 0.0, 1.0);
}

std::optional<double> spatiogram_similarity(const PairPatch& left, const PairPatch& right) {
  double sum = 0.0;
  for (int band = 0; band < left.n_bands; ++band) {
    // The bins cover the values that occur, because fixed bins would put a dark roof into a single
    // one.
    float low = left.colours[0][band];
    float high = low;
    for (const PairPatch* patch : {&left, &right}) {
      for (const Colour& colour : patch->colours) {
        low = std::min(low, colour[band]);
        high = std::max(high, colour[band]);
      }
    }
    if (!(high > low)) return std::nullopt;
    const Spatiogram a = spatiogram(left, band, low, high);
    const Spatiogram b = spatiogram(right, band, low, high);
    for (int bin = 0; bin < kNumBins; ++bin) sum += bin_similarity(a[bin], b[bin]);
  }
  return std::clamp(sum / left.n_bands, 0.0, 1.0);
}

}  // namespace ridgeline::reconstruct
