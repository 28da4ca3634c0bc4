// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/constant_shift.h"

#include "evaluate/probability.h"
#include "evaluate/statistics/bootstrap.h"
#include "evaluate/statistics/distribution.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace ridgeline::evaluate {
namespace {

constexpr double kMaxUndeterminedPart =
    0.1;  // maximum component of a determined axis along directions that are not determined
constexpr double kNormal95 = 1.959964;  // two-sided 95 % quantile of the normal distribution

/// One equation n't = d.
struct Equation {
  Eigen::Vector3d normal;
  double distance_m;
  std::size_t cluster;
};

std::vector<Equation> rows_of(std::span<const LineEvaluation> lines) {
  const std::vector<std::size_t> clusters = cluster_labels(lines);
  std::vector<Equation> rows;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].status != Status::kEvaluated) continue;
    for (const JudgingPlane& p : lines[i].planes) {
      rows.push_back({p.plane.normal(), p.distance.mean, clusters[i]});
    }
  }
  return rows;
}

/// The directions that the planes determine, as columns; the others complete them to a basis.
struct Basis {
  Eigen::Matrix3Xd told, unobservable;
};

/// The basis with unobservable directions that are nearly level made exactly level. The shift along
/// them is assumed to be 0: if they were slightly tilted, a shift of 45 m in height would cause a
/// shift of metres in plan.
Basis levelled(Basis basis) {
  const Eigen::Index n_unobservable = basis.unobservable.cols();
  if (n_unobservable == 0 || n_unobservable == 3 ||
      basis.unobservable.row(2).norm() > kMaxUndeterminedPart)
    return basis;
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  if (n_unobservable == 2) {
    basis.told = z;
    basis.unobservable << x, y;
  } else {
    const Eigen::Vector2d level = basis.unobservable.col(0).head<2>().normalized();
    basis.told << z, level.x() * y - level.y() * x;
    basis.unobservable = level.x() * x + level.y() * y;
  }
  return basis;
}

Basis basis_of(const std::vector<Equation>& rows) {
  constexpr double kNormalError_rad = 1.0 * kRadPerDeg;
  constexpr double kMaxPull = 0.1;  // of the estimate towards 0, due to errors of the normals
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Equation& row : rows) scatter += row.normal * row.normal.transpose();
  scatter /= static_cast<double>(rows.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  const double least = kNormalError_rad * kNormalError_rad / kMaxPull;
  const Eigen::Index n_unobservable = (solver.eigenvalues().array() < least).count();
  return levelled({solver.eigenvectors().rightCols(3 - n_unobservable),
                   solver.eigenvectors().leftCols(n_unobservable)});
}

/// The equations in the coordinates of a basis, with the weights of the last iteration.
class Fit {
 public:
  Fit(const std::vector<Equation>& rows, const Eigen::Matrix3Xd& told)
      : rows_(rows), x_(told.cols(), static_cast<Eigen::Index>(rows.size())) {
    for (Eigen::Index i = 0; i < x_.cols(); ++i) x_.col(i) = told.transpose() * row(i).normal;
    residuals_m_.resize(rows.size());
    weights_.assign(rows.size(), 1.0);
    solve();
    // least absolute deviations: beyond half of the scale, a residual is weighted by its magnitude
    iterate(
        [](double r, double scale_m) { return 1.0 / std::max(1.0, 2.0 * std::abs(r) / scale_m); });
    biweight_m_ = kBiweight * scale_m();  // fixed: lines without weight would shrink it
    iterate([this](double r, double /*scale_m*/) {
      return std::pow(std::max(0.0, 1.0 - std::pow(r / biweight_m_, 2)), 2);
    });
  }

  [[nodiscard]] const Eigen::VectorXd& shift_m() const { return shift_m_; }
  [[nodiscard]] Eigen::Index n_told() const { return x_.rows(); }

  /// The share of each cluster in the information along each axis of the basis; the shares of all
  /// clusters add up to 1.
  [[nodiscard]] std::vector<Eigen::VectorXd> shares() const {
    std::vector<Eigen::VectorXd> parts;
    for (const auto& [label, cluster] : clusters()) {
      parts.emplace_back((inverse_ * cluster.information * inverse_).diagonal());
    }
    const Eigen::VectorXd total = inverse_.diagonal();
    for (Eigen::VectorXd& part : parts) part = part.cwiseQuotient(total).eval();
    return parts;
  }

  [[nodiscard]] Eigen::MatrixXd covariance_m2() const {
    const Eigen::MatrixXd information = derivative_ratio() * information_;
    const auto all = clusters();
    const auto n = static_cast<double>(all.size());
    Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(n_told(), n_told());
    for (const auto& [label, cluster] : all) {
      const Eigen::MatrixXd rest = information - derivative_ratio() * cluster.information;
      const Eigen::VectorXd influence = rest.completeOrthogonalDecomposition().solve(cluster.score);
      scatter += influence * influence.transpose();
    }
    return (n - 1.0) / n * scatter;
  }

 private:
  static constexpr double kBiweight = 4.685;  // 95 % efficiency for normal errors

  struct Cluster {
    Eigen::MatrixXd information;
    Eigen::VectorXd score;  ///< sum of weight x residual x row
  };

  [[nodiscard]] const Equation& row(Eigen::Index i) const {
    return rows_[static_cast<std::size_t>(i)];
  }

  void solve() {
    information_ = Eigen::MatrixXd::Zero(n_told(), n_told());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n_told());
    for (Eigen::Index i = 0; i < x_.cols(); ++i) {
      const double weight = weights_[static_cast<std::size_t>(i)];
      information_ += weight * x_.col(i) * x_.col(i).transpose();
      right += weight * row(i).distance_m * x_.col(i);
    }
    inverse_ = information_.completeOrthogonalDecomposition().pseudoInverse();
    shift_m_ = inverse_ * right;
    for (Eigen::Index i = 0; i < x_.cols(); ++i) {
      residuals_m_[static_cast<std::size_t>(i)] = row(i).distance_m - x_.col(i).dot(shift_m_);
    }
  }

  /// NMAD of the residuals about 0, but at least half a millimetre, the resolution of coordinates
  /// that a file gives in millimetres.
  [[nodiscard]] double scale_m() const {
    constexpr double kMinScale_m = 5e-4;
    constexpr double kNormal = 1.4826;
    std::vector<double> sizes(residuals_m_);
    for (double& r : sizes) r = std::abs(r);
    return std::max(kMinScale_m, kNormal * *median(std::move(sizes)));
  }

  template <typename Weight>
  void iterate(const Weight& weight_at) {
    constexpr int kMaxSteps = 50;
    constexpr double kConverged_m = 1e-10;
    for (int step = 0; step < kMaxSteps; ++step) {
      const double scale = scale_m();
      for (std::size_t i = 0; i < weights_.size(); ++i)
        weights_[i] = weight_at(residuals_m_[i], scale);
      const Eigen::VectorXd before = shift_m_;
      solve();
      if ((shift_m_ - before).norm() < kConverged_m) return;
    }
  }

  /// Mean derivative of the influence function divided by the mean weight: how much less a residual
  /// contributes than its weight suggests. It is 0.83 for normal errors.
  [[nodiscard]] double derivative_ratio() const {
    double weights = 0.0;
    double derivatives = 0.0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      const double u2 = std::pow(residuals_m_[i] / biweight_m_, 2);
      weights += weights_[i];
      if (u2 < 1.0) derivatives += (1.0 - u2) * (1.0 - 5.0 * u2);
    }
    constexpr double kMinDerivative =
        0.1;  // widely spread residuals make the ratio small, and the covariance large
    return std::max(kMinDerivative, derivatives / weights);
  }

  [[nodiscard]] std::map<std::size_t, Cluster> clusters() const {
    std::map<std::size_t, Cluster> all;
    for (Eigen::Index i = 0; i < x_.cols(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (weights_[k] == 0.0) continue;
      const auto [found, is_new] = all.try_emplace(row(i).cluster);
      Cluster& cluster = found->second;
      if (is_new) {
        cluster.information = Eigen::MatrixXd::Zero(n_told(), n_told());
        cluster.score = Eigen::VectorXd::Zero(n_told());
      }
      cluster.information += weights_[k] * x_.col(i) * x_.col(i).transpose();
      cluster.score += weights_[k] * residuals_m_[k] * x_.col(i);
    }
    return all;
  }

  const std::vector<Equation>& rows_;
  Eigen::MatrixXd x_;  ///< one column per row: the normal in the basis
  std::vector<double> residuals_m_, weights_;
  double biweight_m_ = 0.0;  ///< residuals from this magnitude on have no weight
  Eigen::MatrixXd information_, inverse_;
  Eigen::VectorXd shift_m_;
};

/// For each axis of the basis, the number of clusters of equal weight that would provide the same
/// information (Kish 1965).
Eigen::VectorXd effective_clusters(const Fit& fit) {
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(fit.n_told());
  for (const Eigen::VectorXd& share : fit.shares()) squares += share.cwiseAbs2();
  return squares.cwiseInverse();
}

/// Moves axes determined by fewer than two clusters to those that are not determined.
bool drop_lonely(const Eigen::VectorXd& n_clusters, Basis& basis) {
  constexpr double kMinEffectiveClusters = 2.0;
  Eigen::Matrix3Xd told(3, 0);
  for (Eigen::Index i = 0; i < n_clusters.size(); ++i) {
    Eigen::Matrix3Xd& kept = n_clusters[i] >= kMinEffectiveClusters ? told : basis.unobservable;
    kept.conservativeResize(3, kept.cols() + 1);
    kept.rightCols<1>() = basis.told.col(i);
  }
  if (told.cols() == basis.told.cols()) return false;
  basis.told = told;
  basis = levelled(std::move(basis));
  return true;
}

ShiftAxis axis_of(const ConstantShift& shift, int axis) {
  double unobservable = 0.0;
  for (const Eigen::Vector3d& direction : shift.unobservable)
    unobservable += std::pow(direction[axis], 2);
  if (std::sqrt(unobservable) > kMaxUndeterminedPart) return {};
  const double value_m = shift.shift_m[axis];
  const double half_m = kNormal95 * std::sqrt(std::max(0.0, shift.covariance_m2(axis, axis)));
  return {value_m, Interval{value_m - half_m, value_m + half_m}};
}

std::string_view direction_name(const Plane3& plane) {
  constexpr double kFlat_rad = 10.0 * kRadPerDeg;
  if (slope_rad(plane) < kFlat_rad) return "flat";
  const Eigen::Vector3d n = plane.normal();
  if (std::abs(n.y()) >= std::abs(n.x())) return n.y() > 0.0 ? "north" : "south";
  return n.x() > 0.0 ? "east" : "west";
}

std::vector<PlaneDirection> directions_of(std::span<const LineEvaluation> lines) {
  std::vector<PlaneDirection> directions;
  for (const char* const name : {"flat", "north", "east", "south", "west"}) {
    std::vector<double> distances_m;
    std::set<std::uint64_t> planes;
    std::size_t n_lines = 0;
    for (const LineEvaluation& line : lines) {
      if (line.status != Status::kEvaluated) continue;
      const std::size_t n_before = distances_m.size();
      for (const JudgingPlane& p : line.planes) {
        if (direction_name(p.plane) != name) continue;
        distances_m.push_back(p.distance.mean);
        planes.insert(p.id);
      }
      if (distances_m.size() > n_before) ++n_lines;
    }
    if (n_lines == 0) continue;
    directions.push_back({.name = name,
                          .n_lines = n_lines,
                          .n_planes = planes.size(),
                          .mean_m = sum(distances_m) / static_cast<double>(distances_m.size()),
                          .median_m = *median(distances_m)});
  }
  return directions;
}

ConstantShift counted(std::span<const LineEvaluation> lines, const std::vector<Equation>& rows) {
  ConstantShift shift;
  std::set<std::uint64_t> planes;
  for (const LineEvaluation& line : lines) {
    if (line.status != Status::kEvaluated) continue;
    ++shift.n_lines;
    for (const JudgingPlane& p : line.planes) planes.insert(p.id);
  }
  shift.n_planes = planes.size();
  std::set<std::size_t> clusters;
  for (const Equation& row : rows) clusters.insert(row.cluster);
  shift.n_clusters = clusters.size();
  shift.directions = directions_of(lines);
  return shift;
}

}  // namespace

double least_norm(const Eigen::Vector3d& mean,
                  const Eigen::Matrix3d& covariance,
                  double squared_radius) {
  // The smallest x minimises |x|^2 / 2 + m / 2 (x - mean)' C^-1 (x - mean). Along an axis of C with
  // variance c it is mean / (1 + s c), s = 1 / m; its squared distance from the mean, normalised by
  // c, is s^2 mean^2 c / (1 + s c)^2, which grows with s.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Array3d c = solver.eigenvalues().array().max(0.0);
  const Eigen::Array3d along = (solver.eigenvectors().transpose() * mean).array();
  const auto off = [&](double s) {
    return (along * s / (1.0 + s * c)).square().matrix().dot(c.matrix());
  };
  const auto norm = [&](double s) { return (along / (1.0 + s * c)).matrix().norm(); };
  const double most = (c > 0.0).select(along.square() / c, 0.0).sum();
  if (most <= squared_radius) return (c > 0.0).select(0.0, along).matrix().norm();
  constexpr int kHalvings = 200;
  double low = 0.0;
  double high = 1.0;
  while (off(high) < squared_radius) high *= 2.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (off(middle) < squared_radius ? low : high) = middle;
  }
  return norm(low);
}

std::optional<ConstantShift> estimate_shift(std::span<const LineEvaluation> lines,
                                            double accuracy_m) {
  check(accuracy_m >= 0.0, "accuracy_m = ", accuracy_m, ", must be >= 0");
  constexpr double kLevel = 0.95;
  const std::vector<Equation> rows = rows_of(lines);
  if (rows.empty()) return std::nullopt;
  ConstantShift shift = counted(lines, rows);
  shift.accuracy_m = accuracy_m;
  Basis basis = basis_of(rows);
  while (basis.told.cols() > 0) {
    const Fit fit(rows, basis.told);
    const Eigen::VectorXd n_clusters = effective_clusters(fit);
    if (const Eigen::Matrix3Xd told = basis.told; !drop_lonely(n_clusters, basis)) {
      const Eigen::VectorXd widening = n_clusters.unaryExpr(
          [](double n) { return student_t_quantile(n - 1.0, 0.5 * (1.0 + kLevel)) / kNormal95; });
      const Eigen::Matrix3Xd widened = told * widening.asDiagonal();
      shift.shift_m = told * fit.shift_m();
      shift.covariance_m2 = widened * fit.covariance_m2() * widened.transpose();
      break;
    }
  }
  for (Eigen::Index i = 0; i < basis.unobservable.cols(); ++i)
    shift.unobservable.emplace_back(basis.unobservable.col(i));
  for (int axis = 0; axis < 3; ++axis) {
    shift.axes[static_cast<std::size_t>(axis)] = axis_of(shift, axis);
  }
  if (basis.told.cols() > 0) {
    shift.least_m = least_norm(shift.shift_m, shift.covariance_m2,
                               chi_square_quantile(static_cast<double>(basis.told.cols()), kLevel));
  }
  return shift;
}

bool ConstantShift::is_significant() const {
  if (!(least_m > accuracy_m)) return false;
  const auto is_told = [](const ShiftAxis& axis) { return axis.ci95_m.has_value(); };
  const auto n_told = static_cast<std::size_t>(std::ranges::count_if(axes, is_told));
  if (n_told + unobservable.size() < axes.size())
    return true;  // an oblique direction is determined, too
  return std::ranges::any_of(axes, [](const ShiftAxis& axis) {
    return axis.ci95_m && (axis.ci95_m->low > 0.0 || axis.ci95_m->high < 0.0);
  });
}

}  // namespace ridgeline::evaluate
