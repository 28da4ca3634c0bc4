// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "tests/reconstruct/support/line_geometry.h"

#include <Eigen/Cholesky>

namespace ridgeline::test {

/// Squared error of a line across itself, normalised by its covariance: chi-square with 4 degrees
/// of freedom.
inline double nees(const reconstruct::ReconstructedLine& line, const Segment3& truth) {
  Vector6d error;
  error << segment_of(line).start - truth.start, segment_of(line).end - truth.end;
  const Eigen::Matrix<double, 3, 2> across =
      tangent_basis<3>(Eigen::Vector3d(truth.end - truth.start));
  Eigen::Matrix<double, 6, 4> basis = Eigen::Matrix<double, 6, 4>::Zero();
  basis.topLeftCorner<3, 2>() = across;
  basis.bottomRightCorner<3, 2>() = across;
  const Eigen::Vector4d deviation = basis.transpose() * error;
  const Eigen::Matrix4d cov = basis.transpose() * covariance_of(line) * basis;
  return deviation.dot(cov.ldlt().solve(deviation));
}

}  // namespace ridgeline::test
