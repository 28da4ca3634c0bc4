// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"
#include "evaluate/statistics/interval.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// One axis of a shift; both fields are empty if the planes do not determine it.
struct ShiftAxis {
  std::optional<double> shift_m;
  std::optional<Interval> ci95_m;
};

/// The lines judged by planes of one direction.
struct PlaneDirection {
  std::string name;  ///< flat (below 10 degrees), or downslope: north, east, south, west
  std::size_t n_lines = 0, n_planes = 0;
  double mean_m = 0.0, median_m = 0.0;  ///< of the signed distances of the lines
};

/// The offset common to all lines relative to the LIDAR planes: x_in_lines = x_in_planes + shift.
/// World axes, metres.
struct ConstantShift {
  std::size_t n_lines = 0, n_planes = 0, n_clusters = 0;
  std::array<ShiftAxis, 3> axes;  ///< x, y, z
  /// The shift along the directions that the planes determine, and 0 along the others.
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();
  /// 1.96 times its standard deviations are half widths of 95 % intervals: it is widened according
  /// to Student's t distribution for few clusters. 0 along the directions that the planes do not
  /// determine.
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
  std::vector<Eigen::Vector3d>
      unobservable;  ///< orthogonal unit vectors that the planes do not determine
  /// Length of the smallest shift in the 95 % region: the lines are offset from the planes by at
  /// least this much.
  double least_m = 0.0;
  double accuracy_m = 0.0;  ///< of the LIDAR itself; a smaller shift is irrelevant
  std::vector<PlaneDirection> directions;
  std::string cause;     ///< a clause stating what explains the shift; empty if no known cause does
  bool applied = false;  ///< whether the lines were moved by -shift_m before they were judged

  /// Whether the shift is worth reporting: least_m exceeds accuracy_m and, if the planes determine
  /// no oblique direction, the interval of at least one axis excludes 0. An elongated region may
  /// exclude 0 although the intervals of both its axes include it.
  [[nodiscard]] bool is_significant() const;
};

/// Estimates the shift t from the signed distances d of the lines' midpoints from their planes: n't
/// = d for each plane (unit normal n) of each evaluated line. A flat plane determines height only;
/// roofs in two directions determine the plan.
///   - Robust: Tukey's biweight (95 % efficiency for normal errors), which gives a line on a wrong
///     plane no weight, starting from least absolute deviations; the scale is the NMAD.
///   - A direction is considered determined if errors of 1 degree in the planes' normals would pull
///     its estimate towards 0 by at most a tenth, and if at least two clusters determine it. The
///     shift is assumed to be 0 along level directions that are not determined.
///   - Covariance: sandwich estimator over cluster_labels() with the influence of each cluster when
///     it is left out (jackknife, CR3 of MacKinnon and White 1985).
/// `accuracy_m`: of the LIDAR points. Empty if no line is evaluated.
/// Throws std::invalid_argument unless accuracy_m is >= 0.
std::optional<ConstantShift> estimate_shift(std::span<const LineEvaluation> lines,
                                            double accuracy_m);

/// Length of the smallest x with (x - mean)' covariance^-1 (x - mean) <= `squared_radius`, in the
/// space of the axes along which the covariance is positive; along the others x equals the mean. 0
/// if the region contains 0.
double least_norm(const Eigen::Vector3d& mean,
                  const Eigen::Matrix3d& covariance,
                  double squared_radius);

}  // namespace ridgeline::evaluate
