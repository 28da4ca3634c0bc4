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

/// One axis of a shift; both are empty if the planes do not tell it.
struct ShiftAxis {
  std::optional<double> shift_m;
  std::optional<Interval> ci95_m;
};

/// The lines of the planes of one direction.
struct PlaneDirection {
  std::string name;  ///< flat (below 10 degrees), or the way down: north, east, south, west
  std::size_t n_lines = 0, n_planes = 0;
  double mean_m = 0.0, median_m = 0.0;  ///< of the signed distances of the lines
};

/// By how much all lines lie beside the LIDAR planes: x_in_lines = x_in_planes + shift. World axes,
/// metres.
struct ConstantShift {
  std::size_t n_lines = 0, n_planes = 0, n_clusters = 0;
  std::array<ShiftAxis, 3> axes;  ///< x, y, z
  /// The shift along the directions that the planes tell, and 0 along the others.
  Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();
  /// 1.96 times its standard deviations are half widths of 95 % intervals: they are widened as
  /// Student's t distribution is for few clusters. 0 along the directions that the planes do not
  /// tell.
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
  std::vector<Eigen::Vector3d>
      unobservable;  ///< unit vectors at right angles that the planes do not tell
  /// Length of the smallest shift in the 95 % region. The lines lie at least this far beside the
  /// planes.
  double least_m = 0.0;
  double accuracy_m = 0.0;  ///< of the LIDAR itself; a smaller shift matters to nobody
  std::vector<PlaneDirection> directions;
  std::string cause;     ///< a clause on what explains the shift; empty if nothing known does
  bool applied = false;  ///< whether the lines were moved by -shift_m before they were judged

  /// Whether it is worth a word: the region keeps away from 0, and so does the interval of an axis,
  /// if axes are all that the planes tell. A long region may keep away from 0 although both its
  /// intervals hold it.
  [[nodiscard]] bool is_significant() const;
};

/// Estimates the shift t from the signed distances d of the lines' midpoints from their planes: n't
/// = d for each plane (unit normal n) of each evaluated line. A flat plane tells height alone;
/// roofs in two directions tell the plan.
///   - Robust: Tukey's biweight (95 % efficiency for normal errors), which gives a line on a wrong
///     plane no weight, from a start by least absolute deviations; the scale is the NMAD.
///   - A direction counts as told if errors of the planes' normals of 1 degree would draw it to 0
///     by at most a tenth, and if two clusters at least tell it. Level directions that are not told
///     are taken as not shifted.
///   - Covariance: sandwich over cluster_labels() with the influence of each cluster when it is
///     left out (jackknife, CR3 of MacKinnon and White 1985).
/// `accuracy_m`: of the LIDAR's points. Nothing if no line is evaluated.
/// Throws std::invalid_argument unless accuracy_m is >= 0.
std::optional<ConstantShift> estimate_shift(std::span<const LineEvaluation> lines,
                                            double accuracy_m);

/// Length of the smallest x with (x - mean)' covariance^-1 (x - mean) <= `squared_radius`, in the
/// plane of the axes along which the covariance is positive; along the others x equals the mean. 0
/// if the region holds 0.
double least_norm(const Eigen::Vector3d& mean,
                  const Eigen::Matrix3d& covariance,
                  double squared_radius);

}  // namespace ridgeline::evaluate
