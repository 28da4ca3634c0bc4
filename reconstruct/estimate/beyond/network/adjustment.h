// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/network/conditions.h"
#include "reconstruct/estimate/beyond/network/network.h"
#include "reconstruct/estimate/beyond/network/sparse_inverse.h"

#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// The adjustment of a group of lines for given weights of their meetings. It makes Gauss-Newton
/// steps on the manifold of lines, with four unknowns per line (line_tangent_basis()). A step is
/// halved if it would not decrease the sum of squares.
class NetworkAdjustment {
 public:
  /// @param meetings   by indices into `lines`
  /// @param heights_m  lowest and highest height of objects, local frame
  NetworkAdjustment(const ConditionedViews& frames,
                    std::vector<const NetworkLine*> lines,
                    std::vector<Meeting> meetings,
                    const std::array<double, 2>& heights_m,
                    double sigma_slope);

  [[nodiscard]] const std::vector<Meeting>& meetings() const { return meetings_; }
  [[nodiscard]] std::size_t n_lines() const { return lines_.size(); }
  [[nodiscard]] const NetworkLine& line(std::size_t i) const { return *lines_[i]; }
  [[nodiscard]] const Vector6d& estimate(std::size_t i) const { return estimates_[i]; }

  /// Factor for the information of each meeting, 0 to 1.
  std::vector<double> weights;

  /// Returns false if the equations are singular. The adjustment has converged if no line moves by
  /// more than `tolerance_sigma` of its standard deviations. It also stops after `most_passes`
  /// passes or if no step lowers the sum of squares.
  bool minimise(double tolerance_sigma, int most_passes);
  [[nodiscard]] bool converged() const { return converged_; }
  /// Prepares covariance() and predicted(). Returns false if the equations are singular.
  bool invert();

  /// The distance by which the lines of a meeting miss each other, as predicted from everything but
  /// the meeting, in standard deviations of a meeting.
  struct Prediction {
    double miss = 0.0;
    double sigma = 0.0;  ///< sigma due to the lines; infinite if nothing else determines the miss
  };
  /// The prediction from the initial covariances only; of infinite sigma if a line has none.
  [[nodiscard]] Prediction predicted_at_start(std::size_t meeting) const;
  /// The prediction from everything but this meeting, at the current weights. Requires invert()
  /// first.
  [[nodiscard]] Prediction predicted(std::size_t meeting) const;
  [[nodiscard]] Matrix6d covariance(std::size_t line) const;
  [[nodiscard]] double image_omega(std::size_t line) const;

 private:
  struct LineConditions {
    std::vector<ImageCondition> images;         ///< one per observation
    std::array<Eigen::Vector4d, 2> end_planes;  ///< planes of the base segment's start and end
    std::vector<Eigen::Vector4d> base_ends;     ///< planes of NetworkLine::ends in the base view
  };
  [[nodiscard]] double sigma_of(std::size_t meeting) const {
    return meetings_[meeting].junction.sigma_m / frames_.object.scale_m;
  }
  using Basis = Eigen::Matrix<double, 6, 4>;
  [[nodiscard]] LineConditions conditions_of(const NetworkLine& line) const;
  template <typename Add>
  void for_each_condition(std::size_t line, const Vector6d& at, const Add& add) const;
  [[nodiscard]] double sum_of_squares(const std::vector<Vector6d>& at) const;
  [[nodiscard]] Eigen::SparseMatrix<double> normal_matrix(Eigen::VectorXd& right) const;
  /// The lines after the fraction `factor` of a step.
  [[nodiscard]] std::vector<Vector6d> moved(const Eigen::VectorXd& step, double factor) const;
  [[nodiscard]] Eigen::Matrix4d covariance_block(std::size_t row, std::size_t column) const;

  const ConditionedViews& frames_;
  std::vector<const NetworkLine*> lines_;
  std::vector<Meeting> meetings_;
  double sigma_slope_, height_, sigma_height_;  // in the conditioned frame
  std::vector<LineConditions> conditions_;
  std::vector<Vector6d> estimates_;
  std::vector<Basis> bases_;
  std::optional<SparseInverse> inverse_;
  bool converged_ = false;  ///< whether the last minimise() has converged
};

}  // namespace ridgeline::reconstruct
