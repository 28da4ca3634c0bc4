// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/plane_fit.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {

double PlaneFit::sigma_at(const Eigen::Vector3d& x) const {
  const Eigen::Vector2d uv = axes.transpose() * (x - centroid);
  return sigma0_m *
         std::sqrt(1.0 / n + uv.x() * uv.x() / spread_m2.x() + uv.y() * uv.y() / spread_m2.y());
}

std::optional<PlaneFit> fit_plane(std::span<const Eigen::Vector3d> points) {
  constexpr std::size_t kMinPoints = 4;  // 3 unknowns and one residual
  constexpr double kCollinear = 1e-6;  // squared ratio of the spreads across and along: 1 mm on 1 m
  if (points.size() < kMinPoints) return std::nullopt;

  const auto n = static_cast<double>(points.size());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& x : points) sum += x - points.front();
  const Eigen::Vector3d centroid = points.front() + sum / n;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& x : points) {
    const Eigen::Vector3d d = x - centroid;
    scatter.noalias() += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  const Eigen::Vector3d& values = solver.eigenvalues();  // increasing
  if (!(values(1) > kCollinear * values(2))) return std::nullopt;

  PlaneFit fit;
  fit.plane = upward(Plane3(Eigen::Vector3d(solver.eigenvectors().col(0)), centroid));
  fit.centroid = centroid;
  fit.axes << solver.eigenvectors().col(2), solver.eigenvectors().col(1);
  fit.spread_m2 << values(2), values(1);
  fit.n = static_cast<int>(points.size());
  const double squares = std::max(0.0, values(0));
  fit.rms_m = std::sqrt(squares / n);
  fit.sigma0_m = std::sqrt(squares / (n - 3.0));
  return fit;
}

}  // namespace ridgeline::evaluate
