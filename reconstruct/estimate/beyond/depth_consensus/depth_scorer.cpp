// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/depth_consensus/depth_scorer.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

/// Evidence supports a line within this many standard deviations.
constexpr double kSupportSigma = 3.0;
/// Lines that meet end within this distance of each other in the image.
constexpr double kCutReachPx = 6.0;
/// Largest factor by which agreement with the line raises the odds of evidence.
constexpr double kAgreementGain = 4.0;
/// How likely a point above the line is to be off it, relative to a point below the line.
constexpr double kDoubtAbove = 0.1;

}  // namespace

double slope(const Eigen::Vector3d& direction) {
  return std::abs(direction.z()) / direction.head<2>().norm();
}

DepthScorer::DepthScorer(const DepthQuestion& question)
    : question_(question),
      unit_m_(question.lines.frames.object.scale_m),
      reach_(kCutReachPx / question.lines.frames.of(question.line.base()).image.scale_px /
             length(question.line.base().segment)),
      other_from_object_(
          line_projection(question.lines.frames.of(question.line.other()).image_from_object)),
      normal_(question.line.base().plane.mean.head<3>().normalized()) {}

Eigen::Vector3d DepthScorer::horizontal() const {
  const Eigen::Vector3d direction = normal_.cross(Eigen::Vector3d::UnitZ());
  const double norm = direction.norm();
  return norm > 1e-9 ? Eigen::Vector3d(direction / norm) : Eigen::Vector3d::Zero();
}

Eigen::Vector3d DepthScorer::in_plane(const Eigen::Vector3d& v) const {
  return (v - normal_.dot(v) * normal_).normalized();
}

Eigen::Vector3d DepthScorer::mirrored(const Eigen::Vector3d& direction) const {
  const Eigen::Vector3d level = horizontal();
  return 2.0 * level.dot(direction) * level - direction;
}

DepthScorer::ProfileMisfit DepthScorer::misfit(const DepthEvidence& e,
                                               const DepthLine& line) const {
  const Eigen::Vector3d across = normal_.cross(line.direction);
  return {unit_m_ * across.dot(e.x - line.through),
          std::hypot(unit_m_ * std::sqrt(across.dot(e.cov * across)),
                     question_.building.sigma_meeting_m)};
}

bool DepthScorer::supports(const DepthEvidence& e, const DepthLine& line) const {
  const ProfileMisfit m = misfit(e, line);
  return std::abs(m.distance_m) <= kSupportSigma * m.sigma_m;
}

bool DepthScorer::is_at(std::size_t cut, const DepthEvidence& e) const {
  return std::abs(e.parameter - question_.evidence[cut].parameter) <= reach_;
}

std::size_t DepthScorer::line_at(const DepthProfile& profile, double parameter) const {
  const auto cut = std::ranges::upper_bound(
      profile.cuts, parameter, {}, [&](auto c) { return question_.evidence[c].parameter; });
  return static_cast<std::size_t>(cut - profile.cuts.begin());
}

/// Height of the point where the line meets the plane across the base segment.
double DepthScorer::height(const DepthLine& line, double parameter) const {
  const Segment2& base = question_.line.base().segment;
  const Eigen::Vector2d along = base.end - base.start;
  const Eigen::Vector4d plane =
      plane_across(question_.lines.frames.of(question_.line.base()).image_from_object,
                   base.start + parameter * along, along);
  const double s = -plane.dot(line.through.homogeneous()) / plane.head<3>().dot(line.direction);
  return line.through.z() + s * line.direction.z();
}

double DepthScorer::apart_m(const DepthProfile& a, const DepthProfile& b) const {
  constexpr int kPlaces = 9;
  double most = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    const double parameter = static_cast<double>(i) / (kPlaces - 1);
    most = std::max(most, std::abs(height(a.lines[line_at(a, parameter)], parameter) -
                                   height(b.lines[line_at(b, parameter)], parameter)));
  }
  return unit_m_ * most;
}

double DepthScorer::difference_of_ends_m(const DepthProfile& profile) const {
  return unit_m_ * (height(profile.lines.back(), 1.0) - height(profile.lines.front(), 0.0));
}

double DepthScorer::score(const DepthEvidence& e, const DepthLine& line) const {
  const ProfileMisfit m = misfit(e, line);
  const double agreement = bell(m.distance_m / m.sigma_m);
  const bool is_above = m.distance_m * normal_.cross(line.direction).z() > 0.0;
  const double doubt = is_above ? 1.0 - (1.0 - kDoubtAbove) * e.meeting * (1.0 - agreement) : 1.0;
  return std::log(doubt * (1.0 - e.prior) + e.prior * kAgreementGain * agreement);
}

double DepthScorer::score_near_cut(const DepthEvidence& e, const DepthLine& line) const {
  const ProfileMisfit m = misfit(e, line);
  return std::log1p(e.prior * (kAgreementGain - 1.0) * bell(m.distance_m / m.sigma_m));
}

double DepthScorer::score_of_cut(std::size_t cut,
                                 const DepthLine& before,
                                 const DepthLine& after) const {
  const DepthEvidence& e = question_.evidence[cut];
  double agreement = 0.0;
  for (const DepthLine& line : {before, after}) {
    const ProfileMisfit m = misfit(e, line);
    agreement = std::max(agreement, bell(m.distance_m / m.sigma_m));
  }
  return std::log(1.0 - e.prior + e.prior * kAgreementGain * agreement);
}

double DepthScorer::score_of_end(int which, const DepthLine& line) const {
  constexpr double kSigmaHeight_m = 0.2;  // sigma of the heights of lines at the same height
  constexpr double kElsewhere = 0.3;  // share of ends that are not at the height of any nearby line
  if (question_.heights_nearby.empty()) return 0.0;
  const double z = height(line, which);
  double nearest = std::numeric_limits<double>::infinity();
  for (const double other : question_.heights_nearby) {
    nearest = std::min(nearest, std::abs(other - z));
  }
  return std::log(kElsewhere + (1.0 - kElsewhere) * bell(unit_m_ * nearest / kSigmaHeight_m));
}

/// Squared misclosure between the line's image and the segment of the other image, chi-square with
/// 2 degrees of freedom, on the scale of Student's distribution. A shadow or gutter adjoining an
/// edge displaces it by more than its covariance indicates, so no single segment may overrule all
/// points.
double DepthScorer::other_misclosure(const DepthLine& h) const {
  constexpr double kFreedoms = 3.0;
  const UncertainLine2& other = question_.line.other().line;
  Vector6d line;
  line << h.direction, h.through.cross(h.direction);
  Eigen::Vector3d image = (other_from_object_ * line).normalized();
  const Eigen::Matrix<double, 3, 2> basis = tangent_basis<3>(other.mean);
  if (image.dot(other.mean) < 0.0) image = -image;
  const Eigen::Vector2d difference = basis.transpose() * image;
  const Eigen::Matrix2d cov = basis.transpose() * other.cov * basis;
  const double squared = difference.dot(cov.inverse() * difference);
  return (kFreedoms + 2.0) * std::log1p(squared / kFreedoms);
}

double DepthScorer::score(const DepthProfile& profile) const {
  double sum = profile.log_prior;
  sum += score_of_end(0, profile.lines.front()) + score_of_end(1, profile.lines.back());
  for (std::size_t i = 0; i < profile.cuts.size(); ++i) {
    sum += score_of_cut(profile.cuts[i], profile.lines[i], profile.lines[i + 1]);
  }
  for (std::size_t k = 0; k < question_.evidence.size(); ++k) {
    const DepthEvidence& e = question_.evidence[k];
    const auto cut = std::ranges::find_if(profile.cuts, [&](auto c) { return is_at(c, e); });
    if (cut == profile.cuts.end()) {
      sum += score(e, profile.lines[line_at(profile, e.parameter)]);
    } else if (*cut != k) {
      const auto i = static_cast<std::size_t>(cut - profile.cuts.begin());
      sum += std::max(score_near_cut(e, profile.lines[i]), score_near_cut(e, profile.lines[i + 1]));
    }
  }
  double misclosure = 0.0;
  for (const DepthLine& line : profile.lines) {
    misclosure = std::max(misclosure, other_misclosure(line));
  }
  if (question_.surface != nullptr) {
    sum += question_.surface->log_likelihood([&](double parameter) -> const DepthLine& {
      return profile.lines[line_at(profile, parameter)];
    });
  }
  return sum - 0.5 * misclosure;
}

}  // namespace ridgeline::reconstruct
