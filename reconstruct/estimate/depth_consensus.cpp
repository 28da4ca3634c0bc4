// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/depth_consensus.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

/// Within this many standard deviations evidence supports a line.
constexpr double kSupportSigma = 3.0;

struct Hypothesis {
  Eigen::Vector3d through;
  Eigen::Vector3d direction;  ///< unit vector in the projection plane
};

/// 1 at no deviation.
double bell(double z) { return std::exp(-0.5 * z * z); }

double slope(const Eigen::Vector3d& direction) {
  return std::abs(direction.z()) / direction.head<2>().norm();
}

/// The projection plane of the base segment, in which all hypotheses lie, and what they are compared
/// with; lengths in the unit of the conditioned frame.
class Scorer {
 public:
  Scorer(const StereoLines& lines,
         int line,
         std::span<const DepthEvidence> evidence,
         std::span<const double> heights_nearby,
         const ReconstructOptions& options)
      : evidence_(evidence),
        heights_nearby_(heights_nearby),
        options_(options),
        unit_m_(lines.stereo.object.scale_m),
        other_(lines.lines[static_cast<std::size_t>(line)][1]),
        other_from_object_(line_projection(lines.stereo.views[1].image_from_object)),
        normal_(lines.lines[static_cast<std::size_t>(line)][0].plane.mean.head<3>().normalized()) {
    const ObservedLine& base = lines.lines[static_cast<std::size_t>(line)][0];
    const Eigen::Vector2d along = base.segment.end - base.segment.start;
    for (const Eigen::Vector2d& x : {base.segment.start, base.segment.end}) {
      const Eigen::Vector3d across(along.x(), along.y(), -along.dot(x));
      end_planes_.push_back(lines.stereo.views[0].image_from_object.transpose() * across);
    }
  }

  /// Horizontal direction of the plane; zero for a horizontal plane.
  [[nodiscard]] Eigen::Vector3d horizontal() const {
    const Eigen::Vector3d direction = normal_.cross(Eigen::Vector3d::UnitZ());
    const double norm = direction.norm();
    return norm > 1e-9 ? Eigen::Vector3d(direction / norm) : Eigen::Vector3d::Zero();
  }

  [[nodiscard]] Eigen::Vector3d in_plane(const Eigen::Vector3d& v) const {
    return (v - normal_.dot(v) * normal_).normalized();
  }

  /// Distance of evidence from the line within the plane, in its standard deviations.
  struct Misfit {
    double distance_m, sigma_m;
  };
  [[nodiscard]] Misfit misfit(const Hypothesis& h, const DepthEvidence& e) const {
    const Eigen::Vector3d across = normal_.cross(h.direction);
    return {unit_m_ * across.dot(e.x - h.through),
            std::hypot(unit_m_ * std::sqrt(across.dot(e.cov * across)), options_.sigma_meeting_m)};
  }

  /// Largest difference of the heights at the ends of the segment.
  [[nodiscard]] double apart_m(const Hypothesis& a, const Hypothesis& b) const {
    double most = 0.0;
    for (const Eigen::Vector4d& plane : end_planes_) {
      most = std::max(most, std::abs(height(a, plane) - height(b, plane)));
    }
    return unit_m_ * most;
  }

  [[nodiscard]] double score(const Hypothesis& h) const {
    double sum = log_slope_prior(slope(h.direction));
    for (const Eigen::Vector4d& plane : end_planes_) sum += log_height_prior(height(h, plane));
    for (const DepthEvidence& e : evidence_) {
      const Misfit m = misfit(h, e);
      const double agreement = bell(m.distance_m / m.sigma_m);
      const bool is_above = m.distance_m * normal_.cross(h.direction).z() > 0.0;
      const double doubt =
          is_above ? 1.0 - (1.0 - options_.doubt_above) * e.meeting * (1.0 - agreement) : 1.0;
      sum += std::log(doubt * (1.0 - e.prior) + e.prior * options_.agreement_gain * agreement);
    }
    return sum - 0.5 * other_misclosure(h);
  }

 private:
  [[nodiscard]] double log_slope_prior(double slope) const {
    constexpr double kRoofSlope = 0.6;  // 31 degrees; hardly a roof is steeper than twice that
    const double p = options_.horizontal_share;
    return std::log(p * bell(slope / options_.sigma_slope) + (1.0 - p) * bell(slope / kRoofSlope));
  }

  /// Height of the line where it meets a plane.
  [[nodiscard]] static double height(const Hypothesis& h, const Eigen::Vector4d& plane) {
    const double s = -plane.dot(h.through.homogeneous()) / plane.head<3>().dot(h.direction);
    return h.through.z() + s * h.direction.z();
  }

  [[nodiscard]] double log_height_prior(double height) const {
    constexpr double kElsewhere = 0.05;  // of ends that are at the height of no line nearby
    if (heights_nearby_.empty()) return 0.0;
    double nearest = std::numeric_limits<double>::infinity();
    for (const double other : heights_nearby_) {
      nearest = std::min(nearest, std::abs(other - height));
    }
    return std::log(kElsewhere +
                    (1.0 - kElsewhere) * bell(unit_m_ * nearest / options_.sigma_height_m));
  }

  /// Squared misclosure of the line's image with the segment of the other image, chi-square with 2
  /// degrees of freedom; bounded, so that no single match decides against all points.
  [[nodiscard]] double other_misclosure(const Hypothesis& h) const {
    constexpr double kBound = 30.0;
    Vector6d line;
    line << h.direction, h.through.cross(h.direction);
    Eigen::Vector3d image = (other_from_object_ * line).normalized();
    const Eigen::Matrix<double, 3, 2> basis = tangent_basis<3>(other_.line.mean);
    if (image.dot(other_.line.mean) < 0.0) image = -image;
    const Eigen::Vector2d difference = basis.transpose() * image;
    const Eigen::Matrix2d cov = basis.transpose() * other_.line.cov * basis;
    const double squared = difference.dot(cov.inverse() * difference);
    return squared < kBound ? squared : kBound;
  }

  std::span<const DepthEvidence> evidence_;
  std::span<const double> heights_nearby_;
  const ReconstructOptions& options_;
  double unit_m_;
  const ObservedLine& other_;
  Eigen::Matrix<double, 3, 6> other_from_object_;
  Eigen::Vector3d normal_;
  std::vector<Eigen::Vector4d> end_planes_;  ///< across the base segment through its ends
};

std::vector<Hypothesis> hypotheses(const Scorer& scorer, std::span<const DepthEvidence> evidence) {
  std::vector<Hypothesis> all;
  const Eigen::Vector3d horizontal = scorer.horizontal();
  for (std::size_t a = 0; a < evidence.size(); ++a) {
    if (!horizontal.isZero()) all.push_back({evidence[a].x, horizontal});
    for (std::size_t b = a + 1; b < evidence.size(); ++b) {
      if (std::abs(evidence[a].parameter - evidence[b].parameter) < kSmallestBase) continue;
      all.push_back({evidence[a].x, scorer.in_plane(evidence[b].x - evidence[a].x)});
    }
  }
  return all;
}

}  // namespace

std::optional<DepthConsensus> agree_on_depth(const StereoLines& lines,
                                             int line,
                                             std::span<const DepthEvidence> evidence,
                                             std::span<const double> heights_nearby,
                                             const ReconstructOptions& options) {
  constexpr double kAnother_m = 1.0;
  const Scorer scorer(lines, line, evidence, heights_nearby, options);
  const std::vector<Hypothesis> all = hypotheses(scorer, evidence);
  if (all.empty()) return std::nullopt;
  std::vector<double> scores;
  scores.reserve(all.size());
  for (const Hypothesis& h : all) scores.push_back(scorer.score(h));
  const auto at = std::max_element(scores.begin(), scores.end()) - scores.begin();
  const Hypothesis& best = all[static_cast<std::size_t>(at)];
  const double best_score = scores[static_cast<std::size_t>(at)];

  DepthConsensus consensus;
  for (const DepthEvidence& e : evidence) {
    const auto [distance_m, sigma_m] = scorer.misfit(best, e);
    consensus.supports.push_back(std::abs(distance_m) <= kSupportSigma * sigma_m);
  }
  consensus.horizontal = slope(best.direction) <= kSupportSigma * options.sigma_slope;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (scorer.apart_m(all[i], best) <= kAnother_m) continue;
    consensus.margin = std::min(consensus.margin, best_score - scores[i]);
  }
  return consensus;
}

}  // namespace ridgeline::reconstruct
