// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/network/conditions.h"
#include "reconstruct/beyond/network/network.h"
#include "reconstruct/beyond/network/sparse_inverse.h"

#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// The adjustment of a group of lines for given weights of their meetings: Gauss-Newton steps on the
/// manifold of lines, four unknowns each (line_tangent_basis()), halved where they would not decrease
/// the sum of squares.
class NetworkAdjustment {
 public:
  NetworkAdjustment(const StereoViews& stereo,
                    std::vector<const NetworkLine*> lines,
                    std::vector<Meeting> meetings,           ///< by index into `lines`
                    const std::array<double, 2>& heights_m,  ///< of objects, local frame
                    double sigma_slope);

  [[nodiscard]] const std::vector<Meeting>& meetings() const { return meetings_; }
  [[nodiscard]] std::size_t n_lines() const { return lines_.size(); }
  [[nodiscard]] const NetworkLine& line(std::size_t i) const { return *lines_[i]; }
  [[nodiscard]] const Vector6d& estimate(std::size_t i) const { return estimates_[i]; }

  /// Factor of the information of each meeting, 0 to 1.
  std::vector<double> weights;

  /// False if the equations are singular. Converged when no line moves by more than this in its
  /// standard deviations; stops as well after so many passes and where no step lowers the sum.
  bool minimise(double tolerance_sigma, int most_passes);
  [[nodiscard]] bool converged() const { return converged_; }
  /// Computes what covariance() and predicted() give; false if the equations are singular.
  bool invert();

  /// The miss of a meeting as everything else predicts it, in standard deviations of a meeting.
  struct Prediction {
    double miss = 0.0;
    double sigma = 0.0;  ///< of the lines; infinite where nothing else controls the meeting
  };
  /// From the covariances at the start alone; uncontrolled where there is none.
  [[nodiscard]] Prediction predicted_at_start(std::size_t meeting) const;
  /// From all but this meeting, at the current weights; after invert().
  [[nodiscard]] Prediction predicted(std::size_t meeting) const;
  [[nodiscard]] Matrix6d covariance(std::size_t line) const;
  [[nodiscard]] double image_omega(std::size_t line) const;

 private:
  struct LineConditions {
    std::array<ImageCondition, 2> images;
    std::array<Eigen::Vector4d, 2> end_planes;  ///< of the left segment: start, end
    std::vector<Eigen::Vector4d> left_ends;     ///< end planes of NetworkLine::ends
  };
  [[nodiscard]] double sigma_of(std::size_t meeting) const {
    return meetings_[meeting].junction.sigma_m / stereo_.object.scale_m;
  }
  using Basis = Eigen::Matrix<double, 6, 4>;
  [[nodiscard]] LineConditions conditions_of(const NetworkLine& line) const;
  template <typename Add>
  void for_each_condition(std::size_t line, const Vector6d& at, const Add& add) const;
  [[nodiscard]] double sum_of_squares(const std::vector<Vector6d>& at) const;
  [[nodiscard]] Eigen::SparseMatrix<double> normal_matrix(Eigen::VectorXd& right) const;
  /// The lines after a share of a step.
  [[nodiscard]] std::vector<Vector6d> moved(const Eigen::VectorXd& step, double factor) const;
  [[nodiscard]] Eigen::Matrix4d covariance_block(std::size_t row, std::size_t column) const;

  const StereoViews& stereo_;
  std::vector<const NetworkLine*> lines_;
  std::vector<Meeting> meetings_;
  double sigma_slope_, height_, sigma_height_;  // conditioned
  std::vector<LineConditions> conditions_;
  std::vector<Vector6d> estimates_;
  std::vector<Basis> bases_;
  std::optional<SparseInverse> inverse_;
  bool converged_ = false;  ///< by the last minimise()
};

}  // namespace ridgeline::reconstruct
