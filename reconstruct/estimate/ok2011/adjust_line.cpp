// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/adjust_line.h"

#include "reconstruct/geometry/halved_step.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>
#include <optional>

namespace ridgeline::reconstruct {
namespace {

using FromEntity = Eigen::Matrix<double, 6, 4> (*)(const Eigen::Vector4d&);

/// A kind of condition, C(e) M = -G(M) e = 0 for an entity e: two rows of Pi' and Gamma for a
/// plane, of PiBar' and GammaBar for a point.
struct Incidence {
  FromEntity transposed_c;
  RowPair rows;
  Eigen::Matrix<double, 2, 4> g;  ///< G at the current line
};

/// Sums over the conditions, S = G cov_e G'.
struct LineEquations {
  Matrix6d matrix = Matrix6d::Zero();  ///< sum C' S^-1 C
  Vector6d right = Vector6d::Zero();   ///< -sum C' S^-1 (C M)
  double omega = 0.0;                  ///< sum (C M)' S^-1 (C M)

  /// C is taken at the fitted entity e + cov_e G' S^-1 C M, which is on the line. With the observed
  /// entity, the right side would not be the gradient of omega, and lines whose planes nearly
  /// coincide would oscillate.
  void add(const Incidence& incidence, const Uncertain<4>& entity) {
    const Eigen::Matrix<double, 2, 4>& g = incidence.g;
    const Eigen::Vector2d misclosure = -g * entity.mean;
    const Eigen::Matrix2d inverse = (g * entity.cov * g.transpose()).inverse();
    const Eigen::Vector4d fitted = entity.mean + entity.cov * g.transpose() * inverse * misclosure;
    const Eigen::Matrix<double, 2, 6> c =
        select_rows(incidence.transposed_c(fitted).transpose(), incidence.rows);
    matrix += c.transpose() * inverse * c;
    right -= c.transpose() * inverse * misclosure;
    omega += misclosure.dot(inverse * misclosure);
  }

  /// Adds the condition L_h,z / |L_h| = 0: the line is horizontal.
  void add_horizontal(const Vector6d& line, double sigma_slope) {
    const double norm = line.head<3>().norm();
    const double misclosure = line(2) / norm;
    Vector6d c = Vector6d::Zero();
    c.head<3>() = (Eigen::Vector3d::UnitZ() - misclosure * line.head<3>() / norm) / norm;
    const double information = 1.0 / (sigma_slope * sigma_slope);
    matrix += information * c * c.transpose();
    right -= information * misclosure * c;
    omega += information * misclosure * misclosure;
  }
};

/// The entities that determine a line, and the sigma of its slope if it is horizontal.
struct AdjustedConditions {
  std::span<const UncertainPlane3> planes;
  std::span<const UncertainPoint3> points;
  std::optional<double> sigma_slope;
};

LineEquations line_equations(const AdjustedConditions& conditions,
                             const Vector6d& line,
                             int dominant) {
  const RowPair in_plane = line_in_plane_rows(dominant);
  const RowPair on_line = point_on_line_rows(dominant);
  const Incidence plane{pi_matrix, in_plane, select_rows(gamma_matrix(line), in_plane)};
  const Incidence point{pi_bar_matrix, on_line, select_rows(gamma_bar_matrix(line), on_line)};
  LineEquations n;
  for (const UncertainPlane3& p : conditions.planes) n.add(plane, p);
  for (const UncertainPoint3& p : conditions.points) n.add(point, p);
  if (conditions.sigma_slope) n.add_horizontal(line, *conditions.sigma_slope);
  return n;
}

/// The normal equations in the four free directions of the line, solved by their eigenvectors, so
/// that an undetermined direction gets no increment rather than an arbitrary one.
struct Increment {
  Vector6d step;
  Matrix6d cov;
  double largest_in_sigma;  ///< largest increment along an eigenvector, in units of its sigma
  bool full_rank;
};

Increment solve(const LineEquations& n, const Vector6d& line) {
  constexpr double kMinPivot = 1e-12;  // eigenvalue of the block scaled by its mean diagonal
  const Eigen::Matrix<double, 6, 4> basis = line_tangent_basis(line);
  const Eigen::Matrix4d matrix = basis.transpose() * n.matrix * basis;
  const double scale = matrix.trace() / 4.0;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(matrix / scale);

  Eigen::Vector4d inverse = Eigen::Vector4d::Zero();
  int rank = 0;
  for (int i = 0; i < 4; ++i) {
    if (eigen.eigenvalues()(i) < kMinPivot) continue;
    inverse(i) = 1.0 / (eigen.eigenvalues()(i) * scale);
    ++rank;
  }
  const Eigen::Matrix<double, 6, 4> directions = basis * eigen.eigenvectors();
  const Eigen::Vector4d right = directions.transpose() * n.right;
  const Eigen::Vector4d in_sigma = right.cwiseProduct(inverse.cwiseSqrt());
  return {.step = directions * inverse.cwiseProduct(right),
          .cov = directions * inverse.asDiagonal() * directions.transpose(),
          .largest_in_sigma = in_sigma.cwiseAbs().maxCoeff(),
          .full_rank = rank == 4};
}

/// The null vector of all conditions, stacked without weights. Horizontality is one of them,
/// because the iteration does not find it from a vertical line.
Vector6d start_line(const AdjustedConditions& c) {
  Eigen::Matrix<double, Eigen::Dynamic, 6> stacked(4 * (c.planes.size() + c.points.size()) + 1, 6);
  Eigen::Index row = 0;
  for (const UncertainPlane3& plane : c.planes) {
    stacked.middleRows<4>(row) = pi_matrix(plane.mean).transpose();
    row += 4;
  }
  for (const UncertainPoint3& p : c.points) {
    stacked.middleRows<4>(row) = pi_bar_matrix(p.mean).transpose();
    row += 4;
  }
  stacked.row(row).setZero();
  if (c.sigma_slope) stacked(row, 2) = 1.0;
  return project_to_pluecker_quadric(null_vector(stacked));
}

/// The component of the line that selects the rows. It is kept within an adjustment until another
/// one has become more than twice as large, because a change of rows between passes can oscillate.
int keep_or_replace(int dominant, const Vector6d& line) {
  const int largest = dominant_component(line);
  return std::abs(line(largest)) > 2.0 * std::abs(line(dominant)) ? largest : dominant;
}

/// A line, the component that selects its rows, and the normal equations at the line.
struct Linearised {
  Vector6d line;
  int dominant;
  LineEquations normal;
};

Linearised linearise(const AdjustedConditions& conditions,
                     const Vector6d& line,
                     std::optional<int> previous_dominant) {
  const int dominant =
      previous_dominant ? keep_or_replace(*previous_dominant, line) : dominant_component(line);
  return {line, dominant, line_equations(conditions, line, dominant)};
}

}  // namespace

std::optional<AdjustedLine> adjust_line(std::span<const UncertainPlane3> planes,
                                        std::span<const UncertainPoint3> points,
                                        std::optional<double> sigma_slope) {
  constexpr int kMaxPasses = 20;
  // 0.01 would suffice for the accuracy. This value makes the result independent of the frame to
  // the last digits.
  constexpr double kConvergedSigma = 1e-6;
  if (planes.size() + points.size() < 2) return std::nullopt;

  const AdjustedConditions conditions{planes, points, sigma_slope};
  Linearised current = linearise(conditions, start_line(conditions), std::nullopt);
  if (!current.line.allFinite()) return std::nullopt;
  AdjustedLine result;
  while (result.passes < kMaxPasses && !result.converged) {
    const Increment increment = solve(current.normal, current.line);
    const auto after = [&](double share) {
      return linearise(conditions,
                       project_to_pluecker_quadric(current.line + share * increment.step),
                       current.dominant);
    };
    const auto omega = [](const Linearised& l) { return l.normal.omega; };
    if (const auto next = halved_step(omega(current), after, omega)) current = *next;
    result.line.cov = increment.cov;
    result.full_rank = increment.full_rank;
    result.converged = increment.largest_in_sigma < kConvergedSigma;
    ++result.passes;
  }
  result.line.mean = current.line;
  result.omega = current.normal.omega;
  if (!result.line.mean.allFinite() || !result.line.cov.allFinite()) return std::nullopt;
  return result;
}

}  // namespace ridgeline::reconstruct
