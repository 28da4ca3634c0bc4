// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/chio_wang2000/fitted_line.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {

std::optional<FittedLine> fit_line(std::span<const Eigen::Vector3d> points, double correlation) {
  constexpr std::size_t kFewest = 3;
  if (points.size() < kFewest) return std::nullopt;
  const auto n = static_cast<double>(points.size());
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& x : points) centroid += x / n;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& x : points) {
    moments += (x - centroid) * (x - centroid).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments);
  const double spread = axes.eigenvalues().z();
  if (!(spread > 0.0)) return std::nullopt;
  Eigen::Vector3d along = axes.eigenvectors().col(2);
  if (along.dot(points.back() - points.front()) < 0.0) along = -along;

  double first = HUGE_VAL;
  double last = -HUGE_VAL;
  for (const Eigen::Vector3d& x : points) {
    first = std::min(first, along.dot(x - centroid));
    last = std::max(last, along.dot(x - centroid));
  }
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along * along.transpose();
  const Eigen::Matrix3d scatter = across * moments * across * (correlation / (n - 2.0));

  FittedLine line;
  line.segment = {centroid + first * along, centroid + last * along};
  const auto block = [&](double s, double t) { return scatter * (1.0 / n + s * t / spread); };
  line.cov_m2 << block(first, first), block(first, last), block(last, first), block(last, last);
  return line;
}

}  // namespace ridgeline::reconstruct
