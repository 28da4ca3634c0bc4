// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/scan/edge_model.h"

#include "evaluate/probability.h"

#include <Eigen/Dense>

namespace ridgeline::evaluate {
namespace {

/// By how much intervals of 1.96 sigma must be widened because a few points determine sigma.
double widening(const PlaneFit& plane) {
  constexpr double kInterval = 0.975;
  if (plane.n <= 3) return 1.0;
  return student_t_quantile(plane.n - 3.0, kInterval) / normal_quantile(kInterval);
}

/// Covariance of (a, b) of the displacement a + b s of a plane along its normal, at the places
/// middle + s direction.
Eigen::Matrix2d plane_covariance(const PlaneFit& plane,
                                 const Eigen::Vector3d& middle,
                                 const Eigen::Vector3d& direction) {
  const Eigen::Vector2d at = plane.axes.transpose() * (middle - plane.centroid);
  const Eigen::Vector2d along = plane.axes.transpose() * direction;
  Eigen::Matrix<double, 2, 3> j;
  j << 1.0, at.x(), at.y(), 0.0, along.x(), along.y();
  const Eigen::Vector3d variances(1.0 / plane.n, 1.0 / plane.spread_m2.x(),
                                  1.0 / plane.spread_m2.y());
  const double sigma_m = widening(plane) * plane.sigma0_m;
  return sigma_m * sigma_m * j * variances.asDiagonal() * j.transpose();
}

EdgeModel line_through(const Segment3& segment) {
  EdgeModel model;
  model.middle = midpoint(segment);
  model.direction = (segment.end - segment.start).normalized();
  return model;
}

}  // namespace

double EdgeModel::variance_m2(double s) const {
  Eigen::Matrix<double, 2, 4> j;
  j << Eigen::Matrix2d::Identity(), s * Eigen::Matrix2d::Identity();
  return 0.5 * (j * covariance * j.transpose()).trace();
}

Eigen::Matrix<double, 6, 6> EdgeModel::covariance_of_ends(
    const Segment3& segment, const std::array<double, 2>& along_m2) const {
  const double s0 = direction.dot(segment.start - middle), s1 = direction.dot(segment.end - middle);
  Eigen::Matrix<double, 6, 4> j;
  j << across, s0 * across, across, s1 * across;
  Eigen::Matrix<double, 6, 6> result = j * covariance * j.transpose();
  const Eigen::Matrix3d along = direction * direction.transpose();
  result.topLeftCorner<3, 3>() += along_m2[0] * along;
  result.bottomRightCorner<3, 3>() += along_m2[1] * along;
  return result;
}

EdgeModel model_of_seam(const Segment3& segment, const PlaneFit& a, const PlaneFit& b) {
  EdgeModel model = line_through(segment);
  const Eigen::Vector3d w = a.plane.normal();
  model.across << w, model.direction.cross(w);
  Eigen::Matrix2d n;  // displacement of each plane by a displacement of the line
  n << 1.0, 0.0, b.plane.normal().dot(model.across.col(0)),
      b.plane.normal().dot(model.across.col(1));
  const Eigen::Matrix2d inverse = n.inverse();
  Eigen::Matrix4d planes = Eigen::Matrix4d::Zero();  // of (a of both planes, b of both planes)
  const std::array fits{&a, &b};
  for (Eigen::Index i = 0; i < 2; ++i) {
    const Eigen::Matrix2d c =
        plane_covariance(*fits[static_cast<std::size_t>(i)], model.middle, model.direction);
    for (Eigen::Index k = 0; k < 2; ++k)
      for (Eigen::Index l = 0; l < 2; ++l) planes(i + 2 * k, i + 2 * l) = c(k, l);
  }
  Eigen::Matrix4d j = Eigen::Matrix4d::Zero();
  j.topLeftCorner<2, 2>() = inverse;
  j.bottomRightCorner<2, 2>() = inverse;
  model.covariance = j * planes * j.transpose();
  return model;
}

EdgeModel model_of_border(const Segment3& segment,
                          const Eigen::Vector3d& out,
                          const PlaneFit& plane,
                          const BorderLine& line) {
  EdgeModel model = line_through(segment);
  model.across << out, model.direction.cross(out);
  const Eigen::Matrix2d c = plane_covariance(plane, model.middle, model.direction);
  for (Eigen::Index k = 0; k < 2; ++k) {
    for (Eigen::Index l = 0; l < 2; ++l) {
      model.covariance(2 * k, 2 * l) = line.covariance(k, l);
      model.covariance(2 * k + 1, 2 * l + 1) = c(k, l);
    }
  }
  return model;
}

}  // namespace ridgeline::evaluate
