// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/depth_consensus/depth_scorer.h"

#include "reconstruct/beyond/depth_consensus/bell.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridgeline::reconstruct {
namespace {

/// Within this many standard deviations evidence supports a line.
constexpr double kSupportSigma = 3.0;
}  // namespace

double slope(const Eigen::Vector3d& direction) {
  return std::abs(direction.z()) / direction.head<2>().norm();
}

DepthScorer::DepthScorer(const DepthQuestion& question)
    : question_(question),
      unit_m_(question.lines.stereo.object.scale_m),
      other_from_object_(line_projection(question.lines.stereo.views[1].image_from_object)),
      normal_(question.line[0].plane.mean.head<3>().normalized()) {}

Eigen::Vector3d DepthScorer::horizontal() const {
  const Eigen::Vector3d direction = normal_.cross(Eigen::Vector3d::UnitZ());
  const double norm = direction.norm();
  return norm > 1e-9 ? Eigen::Vector3d(direction / norm) : Eigen::Vector3d::Zero();
}

Eigen::Vector3d DepthScorer::in_plane(const Eigen::Vector3d& v) const {
  return (v - normal_.dot(v) * normal_).normalized();
}

DepthScorer::Misfit DepthScorer::misfit(const DepthEvidence& e, const DepthLine& line) const {
  const Eigen::Vector3d across = normal_.cross(line.direction);
  return {unit_m_ * across.dot(e.x - line.through),
          std::hypot(unit_m_ * std::sqrt(across.dot(e.cov * across)),
                     question_.options.sigma_meeting_m)};
}

bool DepthScorer::supports(const DepthEvidence& e, const DepthLine& line) const {
  const Misfit m = misfit(e, line);
  return std::abs(m.distance_m) <= kSupportSigma * m.sigma_m;
}

/// Where the line meets the plane across the base segment.
double DepthScorer::height(const DepthLine& line, double parameter) const {
  const Segment2& base = question_.line[0].segment;
  const Eigen::Vector2d along = base.end - base.start;
  const Eigen::Vector2d x = base.start + parameter * along;
  const Eigen::Vector4d plane = question_.lines.stereo.views[0].image_from_object.transpose() *
                                Eigen::Vector3d(along.x(), along.y(), -along.dot(x));
  const double s = -plane.dot(line.through.homogeneous()) / plane.head<3>().dot(line.direction);
  return line.through.z() + s * line.direction.z();
}

double DepthScorer::apart_m(const DepthLine& a, const DepthLine& b) const {
  return unit_m_ * std::max(std::abs(height(a, 0.0) - height(b, 0.0)),
                            std::abs(height(a, 1.0) - height(b, 1.0)));
}

double DepthScorer::score(const DepthEvidence& e, const DepthLine& line) const {
  const ReconstructOptions& o = question_.options;
  const Misfit m = misfit(e, line);
  const double agreement = bell(m.distance_m / m.sigma_m);
  const bool is_above = m.distance_m * normal_.cross(line.direction).z() > 0.0;
  const double doubt = is_above ? 1.0 - (1.0 - o.doubt_above) * e.meeting * (1.0 - agreement) : 1.0;
  return std::log(doubt * (1.0 - e.prior) + e.prior * o.agreement_gain * agreement);
}

double DepthScorer::score_of_end(int which, const DepthLine& line) const {
  constexpr double kElsewhere = 0.3;  // of ends that are at the height of no line nearby
  if (question_.heights_nearby.empty()) return 0.0;
  const double z = height(line, which);
  double nearest = std::numeric_limits<double>::infinity();
  for (const double other : question_.heights_nearby) {
    nearest = std::min(nearest, std::abs(other - z));
  }
  return std::log(kElsewhere +
                  (1.0 - kElsewhere) * bell(unit_m_ * nearest / question_.options.sigma_height_m));
}

/// Squared misclosure of the line's image with the segment of the other image, chi-square with 2
/// degrees of freedom, as that of Student's distribution: what adjoins an edge, a shadow or a gutter,
/// displaces it by more than its covariance tells, and no single match decides against all points.
double DepthScorer::other_misclosure(const DepthLine& h) const {
  constexpr double kFreedoms = 3.0;
  const UncertainLine2& other = question_.line[1].line;
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

double DepthScorer::score(const DepthHypothesis& hypothesis) const {
  const DepthLine& line = hypothesis.line;
  double sum = hypothesis.log_prior + score_of_end(0, line) + score_of_end(1, line);
  for (const DepthEvidence& e : question_.evidence) sum += score(e, line);
  if (question_.flanks != nullptr) {
    sum += question_.flanks->log_likelihood([&](double) -> const DepthLine& { return line; });
  }
  return sum - 0.5 * other_misclosure(line);
}

}  // namespace ridgeline::reconstruct
