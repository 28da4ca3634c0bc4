// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plane_sigma.h"

#include "evaluate/probability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace ridgeline::evaluate {
namespace {

constexpr int kParameters = 3;  // of a plane

/// The factor by which the 95 % interval is wider than for a sigma that is known exactly.
double widening(int degrees_of_freedom) {
  constexpr double kNormal = 1.959964;
  if (degrees_of_freedom < 1) return std::numeric_limits<double>::infinity();
  return student_t_quantile(degrees_of_freedom, 0.975) / kNormal;
}

/// (1, u, v), with (u, v) the coordinates of x in the plane.
Eigen::Vector3d row_of(const PlaneFit& fit, const Eigen::Vector3d& x) {
  const Eigen::Vector2d uv = fit.axes.transpose() * (x - fit.centroid);
  return {1.0, uv.x(), uv.y()};
}

double cluster_robust_sigma_m(const PlaneFit& fit,
                              std::span<const ZonePoint> points,
                              const Eigen::Vector3d& x) {
  constexpr double kCell_m = 2.0;  // best of 1 to 3 m on the simulated villages 1 to 8
  std::map<std::pair<double, double>, Eigen::Vector3d> sums;
  for (const ZonePoint& p : points) {
    const std::pair cell(std::floor(p.s / kCell_m), std::floor(p.t / kCell_m));
    auto [sum, is_new] = sums.try_emplace(cell, Eigen::Vector3d::Zero());
    sum->second += fit.plane.signedDistance(p.x) * row_of(fit, p.x);
  }
  const auto n_cells = static_cast<int>(sums.size());
  if (n_cells <= kParameters) return 0.0;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& [cell, sum] : sums) scatter += sum * sum.transpose();
  // the axes are principal and originate at the centroid, so that the normal equations are diagonal
  const Eigen::Vector3d influence =
      row_of(fit, x).cwiseQuotient(Eigen::Vector3d(fit.n, fit.spread_m2.x(), fit.spread_m2.y()));
  const double few_cells = static_cast<double>(n_cells) / (n_cells - kParameters);
  return std::sqrt(few_cells * influence.dot(scatter * influence)) *
         widening(n_cells - kParameters);
}

}  // namespace

double plane_sigma_m(const PlaneFit& fit,
                     std::span<const ZonePoint> points,
                     const Eigen::Vector3d& x) {
  return std::max(fit.sigma_at(x) * widening(fit.n - kParameters),
                  cluster_robust_sigma_m(fit, points, x));
}

}  // namespace ridgeline::evaluate
