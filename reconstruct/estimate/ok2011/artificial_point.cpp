// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/artificial_point.h"

#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/uncertain/pluecker.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <vector>

namespace ridgeline::reconstruct {
namespace {

using Matrix5d = Eigen::Matrix<double, 5, 5>;
using Vector5d = Eigen::Matrix<double, 5, 1>;

/// One image point within the adjustment. The two rows of S(x) P X = 0 are always chosen by the
/// largest component of the observed x.
struct Adjusted {
  const ViewedPoint& observation;
  RowPair rows;
  Eigen::Vector3d fitted;  ///< l_0: the adjusted observation so far
};

/// The linearised conditions of one image, in the symbols of the Gauss-Helmert model.
struct Conditions {
  Eigen::Matrix<double, 2, 4> a;            ///< dg/dX
  Eigen::Matrix<double, 2, 3> b_transpose;  ///< dg/dl
  Eigen::Vector3d v;                        ///< l_0 - l
  Eigen::Vector2d misclosure;               ///< c_g = -g(l_0, X_0) + B' v
  Eigen::Matrix2d weight;                   ///< W = (B' cov_l B)^-1
};

Adjusted start_values(const ViewedPoint& observation) {
  Eigen::Index largest = 0;
  observation.point.mean.cwiseAbs().maxCoeff(&largest);
  const int k = static_cast<int>(largest);
  return {observation, {(k + 1) % 3, (k + 2) % 3}, observation.point.mean};
}

Conditions linearise(const Adjusted& image, const Eigen::Vector4d& x) {
  const ProjectionMatrix& p = image.observation.image_from_object;
  Conditions c;
  c.a = select_rows(Eigen::Matrix<double, 3, 4>(skew(image.fitted) * p), image.rows);
  c.b_transpose = select_rows(Eigen::Matrix3d(-skew(p * x)), image.rows);
  c.v = image.fitted - image.observation.point.mean;
  c.misclosure = -c.a * x + c.b_transpose * c.v;
  c.weight = (c.b_transpose * image.observation.point.cov * c.b_transpose.transpose()).inverse();
  return c;
}

Eigen::Vector4d first_guess(std::span<const ViewedPoint> observations) {
  Eigen::Matrix<double, Eigen::Dynamic, 4> stacked(3 * observations.size(), 4);
  for (std::size_t j = 0; j < observations.size(); ++j) {
    stacked.middleRows<3>(static_cast<Eigen::Index>(3 * j)) =
        skew(observations[j].point.mean) * observations[j].image_from_object;
  }
  return null_vector(stacked);
}

/// The normal equations bordered by the length constraint h = (X'X - 1) / 2. Their upper block is
/// divided by `scale`, so that block and border have the same magnitude for any precision of the
/// observations.
struct NormalEquations {
  Matrix5d matrix = Matrix5d::Zero();
  Vector5d right = Vector5d::Zero();
  double scale = 1.0;
};

NormalEquations normal_equations(std::span<const Conditions> conditions, const Eigen::Vector4d& x) {
  NormalEquations n;
  for (const Conditions& c : conditions) {
    n.matrix.topLeftCorner<4, 4>() += c.a.transpose() * c.weight * c.a;
    n.right.head<4>() += c.a.transpose() * c.weight * c.misclosure;
  }
  n.scale = n.matrix.trace() / 4.0;
  n.matrix /= n.scale;
  n.right /= n.scale;
  n.matrix.topRightCorner<4, 1>() = x;
  n.matrix.bottomLeftCorner<1, 4>() = x.transpose();
  n.right(4) = 0.5 * (1.0 - x.squaredNorm());
  return n;
}

}  // namespace

std::optional<EstimatedPoint> estimate_point(std::span<const ViewedPoint> observations) {
  constexpr int kMaxPasses = 10;
  constexpr double kConverged = 1e-10;  // change of the unit vector; 1e-8 m in a patch of 100 m
  check(observations.size() >= 2, "estimate_point: observations = ", observations.size(),
        ", must be at least 2");

  std::vector<Adjusted> images;
  for (const ViewedPoint& observation : observations) {
    images.push_back(start_values(observation));
  }
  Eigen::Vector4d x = first_guess(observations);
  std::vector<Conditions> conditions(images.size());
  for (int pass = 1; pass <= kMaxPasses; ++pass) {
    for (std::size_t j = 0; j < images.size(); ++j) conditions[j] = linearise(images[j], x);
    const NormalEquations normal = normal_equations(conditions, x);
    const Eigen::FullPivLU<Matrix5d> lu(normal.matrix);
    const Eigen::Vector4d dx = lu.solve(normal.right).head<4>();
    if (!lu.isInvertible() || !dx.allFinite()) return std::nullopt;

    double omega = 0.0;
    for (std::size_t j = 0; j < images.size(); ++j) {
      const Conditions& c = conditions[j];
      const Eigen::Vector2d residual = c.misclosure - c.a * dx;
      omega += residual.dot(c.weight * residual);
      images[j].fitted +=
          observations[j].point.cov * c.b_transpose.transpose() * c.weight * residual - c.v;
    }
    x += dx;
    if (dx.norm() < kConverged) {
      return EstimatedPoint{
          {x.normalized(), lu.inverse().topLeftCorner<4, 4>() / normal.scale}, omega, pass};
    }
  }
  return std::nullopt;
}

}  // namespace ridgeline::reconstruct
