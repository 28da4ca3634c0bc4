// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/side_planes.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

constexpr int kMinDistance_px = 3;   // half a matching block away from the step at the line
constexpr int kMaxDistance_px = 12;  // points at this distance are still on the roof
constexpr double kOnSide_px = 0.6;
constexpr double kMaxSideSlope = 0.6;  // change of disparity per pixel; steeper for walls

struct Sample {
  Eigen::Vector3d by;  ///< 1, t, s
  double d;
};

std::vector<Sample> samples_beside(const Surface& surface,
                                   const Segment2& segment,
                                   int side,
                                   std::size_t& n_all) {
  const Eigen::Vector2d u = along(segment);
  const Eigen::Vector2d n = side * normal_of(u);
  const double half = 0.5 * length(segment);
  const int n_along = std::max(2, static_cast<int>(2.0 * half) + 1);
  std::vector<Sample> samples;
  n_all = 0;
  for (int i = 0; i < n_along; ++i) {
    const double t = -half + 2.0 * half * i / (n_along - 1);
    for (int s = kMinDistance_px; s <= kMaxDistance_px; ++s) {
      ++n_all;
      if (const auto d = surface.at(midpoint(segment) + t * u + s * n))
        samples.push_back({{1.0, t, static_cast<double>(s)}, *d});
    }
  }
  return samples;
}

std::optional<Eigen::Vector3d> plane_through(const std::array<const Sample*, 3>& samples) {
  Eigen::Matrix3d by;
  Eigen::Vector3d d;
  for (Eigen::Index i = 0; i < 3; ++i) {
    by.row(i) = samples[static_cast<std::size_t>(i)]->by.transpose();
    d[i] = samples[static_cast<std::size_t>(i)]->d;
  }
  if (std::abs(by.determinant()) < 1.0) return std::nullopt;
  const Eigen::Vector3d plane = by.inverse() * d;
  if (plane.tail<2>().cwiseAbs().maxCoeff() > kMaxSideSlope) return std::nullopt;
  return plane;
}

/// Sum of the squared normalised distances of the samples from a plane, each limited to 1, the
/// value of an outlier.
double cost_of(const Eigen::Vector3d& plane, const std::vector<Sample>& samples) {
  double cost = 0.0;
  for (const Sample& s : samples) {
    const double off = (plane.dot(s.by) - s.d) / kOnSide_px;
    cost += std::min(1.0, off * off);
  }
  return cost;
}

/// The plane through three samples that has the lowest cost_of().
std::optional<Eigen::Vector3d> best_plane(const std::vector<Sample>& samples) {
  constexpr int kTries = 60;
  std::minstd_rand random(1);  // the fixed seed makes the result the same in every run
  const auto any = [&] { return &samples[random() % samples.size()]; };
  std::optional<Eigen::Vector3d> best;
  double least = HUGE_VAL;
  for (int i = 0; i < kTries; ++i) {
    const auto plane = plane_through({any(), any(), any()});
    if (!plane) continue;
    const double cost = cost_of(*plane, samples);
    if (cost >= least) continue;
    least = cost;
    best = plane;
  }
  return best;
}

/// Fits a plane by least squares to samples that lie on it. The errors of neighbouring samples are
/// correlated, because the matching smooths.
SidePlane fitted(const std::vector<Sample>& samples, const Eigen::Vector3d& start) {
  constexpr double kTogether = 100.0;  // number of pixels with a common error
  // Prior sigma of the slope away from the line, px per px: the spread of roof slopes.
  constexpr double kSlopeSigma = 0.15;
  constexpr double kMinSigma_px = 0.05;
  double squares = 0.0;
  for (const Sample& s : samples) squares += std::pow(start.dot(s.by) - s.d, 2.0);
  const double variance = kTogether * std::max(kMinSigma_px * kMinSigma_px,
                                               squares / static_cast<double>(samples.size()));
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  normal(2, 2) = 1.0 / (kSlopeSigma * kSlopeSigma);
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Sample& s : samples) {
    normal += s.by * s.by.transpose() / variance;
    right += s.by * s.d / variance;
  }
  SidePlane plane;
  plane.cov = normal.inverse();
  plane.at_middle_along_away = plane.cov * right;
  return plane;
}

}  // namespace

double SidePlane::sigma_on_line_px(double t_px) const {
  constexpr double kEdge_px = 0.3;
  const Eigen::Vector3d by(1.0, t_px, 0.0);
  return std::hypot(kEdge_px, std::sqrt(by.dot(cov * by)));
}

std::optional<SidePlane> side_plane(const Surface& surface, const Segment2& rectified, int side) {
  constexpr std::size_t kMinSamples = 10;
  std::size_t n_all = 0;
  std::vector<Sample> samples = samples_beside(surface, rectified, side, n_all);
  if (2 * samples.size() < n_all || samples.size() < kMinSamples) return std::nullopt;
  const auto best = best_plane(samples);
  if (!best) return std::nullopt;
  std::erase_if(samples,
                [&](const Sample& s) { return std::abs(best->dot(s.by) - s.d) > kOnSide_px; });
  SidePlane plane = fitted(samples, *best);
  plane.share = static_cast<double>(samples.size()) / static_cast<double>(n_all);
  return plane;
}

const SidePlane* SidesOfPiece::nearer() const {
  const SidePlane* found = nullptr;
  for (const auto& plane : planes) {
    if (plane && (found == nullptr || plane->on_line(0.0) > found->on_line(0.0))) found = &*plane;
  }
  return found;
}

SidesOfPiece sides_of(const Surface& surface,
                      const Segment2& rectified,
                      const std::array<double, 2>& parameters) {
  const Segment2 piece{point_at(rectified, parameters[0]), point_at(rectified, parameters[1])};
  return {
      parameters, length(piece), {side_plane(surface, piece, 1), side_plane(surface, piece, -1)}};
}

std::vector<SidesOfPiece> sides_along(const Surface& surface, const Segment2& rectified) {
  constexpr double kPiece_px = 30.0;
  constexpr int kMaxPieces = 10;
  const int n = std::clamp(static_cast<int>(length(rectified) / kPiece_px), 1, kMaxPieces);
  std::vector<SidesOfPiece> pieces;
  pieces.reserve(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    pieces.push_back(
        sides_of(surface, rectified, {static_cast<double>(i) / n, static_cast<double>(i + 1) / n}));
  }
  return pieces;
}

}  // namespace ridgeline::reconstruct
