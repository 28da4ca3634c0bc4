// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scene/choose_views.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>

namespace ridgeline::reconstruct {
namespace {

constexpr std::size_t kDirections = 8;  ///< number of line directions in plan
constexpr double kMinSeenShare = 0.1;

/// Information matrices of the position across a line, horizontal and vertical, for each direction.
using OfDirections = std::array<Eigen::Matrix2d, kDirections>;

bool sees(const CandidateView& view, const Eigen::Vector3d& x) {
  const Eigen::Vector3d y = view.image_from_local * x.homogeneous();
  const double side = view.image_from_local.leftCols<3>().determinant() > 0.0 ? 1.0 : -1.0;
  if (!(side * y.z() > 0.0)) return false;
  const Eigen::Vector2d px = y.hnormalized();
  return px.x() >= 0.0 && px.y() >= 0.0 && px.x() <= view.size_px.x() - 1.0 &&
         px.y() <= view.size_px.y() - 1.0;
}

/// Focal length in pixels: the geometric mean over both image axes.
double focal_length_px(const ProjectionMatrix& P) {
  const Eigen::Vector3d axis = P.row(2).head<3>().transpose();
  const auto of_row = [&](int row) {
    const Eigen::Vector3d m = P.row(row).head<3>().transpose();
    return m.cross(axis).norm() / axis.squaredNorm();
  };
  return std::sqrt(of_row(0) * of_row(1));
}

/// The information that a view contributes on lines at one point.
OfDirections information(const CandidateView& view,
                         const Eigen::Vector3d& centre,
                         const Eigen::Vector3d& x) {
  const Eigen::Vector3d ray = x - centre;
  const double pixel_m = ray.norm() / focal_length_px(view.image_from_local);
  OfDirections all;
  for (std::size_t k = 0; k < kDirections; ++k) {
    const double azimuth = std::numbers::pi * static_cast<double>(k) / kDirections;
    const Eigen::Vector3d along(std::cos(azimuth), std::sin(azimuth), 0.0);
    const Eigen::Vector3d across(-along.y(), along.x(), 0.0);
    const Eigen::Vector3d normal = ray.cross(along).normalized();
    const Eigen::Vector2d n(normal.dot(across), normal.z());
    all[k] = n * n.transpose() / (pixel_m * pixel_m);
  }
  return all;
}

class Chooser {
 public:
  Chooser(std::span<const CandidateView> candidates,
          std::span<const Eigen::Vector3d> points,
          double height_range_m)
      : candidates_(candidates), points_(points) {
    const double prior_m = 0.5 * height_range_m;
    OfDirections prior;
    prior.fill(Eigen::Matrix2d::Identity() / (prior_m * prior_m));
    known_.assign(points.size(), prior);
    for (const CandidateView& view : candidates) {
      centres_.emplace_back(projection_centre(view.image_from_local).hnormalized());
      shares_.push_back(seen_share(view, points));
    }
    middle_.setZero();
    for (const Eigen::Vector3d& x : points) middle_ += x / static_cast<double>(points.size());
  }

  std::vector<std::size_t> choose(std::size_t max_views) {
    while (chosen_.size() < max_views) {
      const std::optional<std::size_t> next = chosen_.empty() ? base() : best_next();
      if (!next) break;
      take(*next);
    }
    return chosen_;
  }

 private:
  [[nodiscard]] std::optional<std::size_t> base() const {
    constexpr double kTenths = 10.0;
    return best([&](std::size_t i) -> std::optional<double> {
      if (shares_[i] < kMinSeenShare) return std::nullopt;
      const Eigen::Vector3d ray = (middle_ - centres_[i]).normalized();
      return -std::round(kTenths * shares_[i]) + 0.5 * (1.0 + ray.z());
    });
  }

  [[nodiscard]] std::optional<std::size_t> best_next() const {
    constexpr double kMaxRatio = 0.6;
    const auto cost_within = [&](double most) {
      return [this, most](std::size_t i) -> std::optional<double> {
        constexpr double kMinRatio = 0.02;
        const double ratio = least_ratio(i);
        if (shares_[i] < kMinSeenShare || ratio < kMinRatio || ratio > most) return std::nullopt;
        return uncertainty_with(i);
      };
    };
    const auto next = best(cost_within(kMaxRatio));
    return next ? next : best(cost_within(std::numeric_limits<double>::infinity()));
  }

  /// The unchosen candidate with the lowest cost; std::nullopt if none has a cost.
  template <typename Cost>
  [[nodiscard]] std::optional<std::size_t> best(const Cost& cost) const {
    std::optional<std::size_t> found;
    std::tuple<double, std::string> key;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (std::ranges::find(chosen_, i) != chosen_.end()) continue;
      const std::optional<double> value = cost(i);
      if (!value) continue;
      std::tuple<double, std::string> of_candidate(*value, candidates_[i].id);
      if (found && key <= of_candidate) continue;
      found = i;
      key = std::move(of_candidate);
    }
    return found;
  }

  /// The smallest base-to-height ratio to a chosen view.
  [[nodiscard]] double least_ratio(std::size_t i) const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t j : chosen_) {
      const double way_m = 0.5 * ((centres_[i] - middle_).norm() + (centres_[j] - middle_).norm());
      least = std::min(least, (centres_[i] - centres_[j]).norm() / way_m);
    }
    return least;
  }

  [[nodiscard]] double uncertainty_with(std::size_t i) const {
    double sum = 0.0;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      OfDirections known = known_[p];
      if (sees(candidates_[i], points_[p])) add(information_of(i, p), known);
      for (const Eigen::Matrix2d& matrix : known) sum += std::log(matrix.inverse().trace());
    }
    return sum;
  }

  void take(std::size_t i) {
    chosen_.push_back(i);
    for (std::size_t p = 0; p < points_.size(); ++p)
      if (sees(candidates_[i], points_[p])) add(information_of(i, p), known_[p]);
  }

  [[nodiscard]] OfDirections information_of(std::size_t i, std::size_t p) const {
    return information(candidates_[i], centres_[i], points_[p]);
  }

  static void add(const OfDirections& more, OfDirections& known) {
    for (std::size_t k = 0; k < kDirections; ++k) known[k] += more[k];
  }

  std::span<const CandidateView> candidates_;
  std::span<const Eigen::Vector3d> points_;
  std::vector<OfDirections> known_;  ///< by point
  std::vector<Eigen::Vector3d> centres_;
  std::vector<double> shares_;
  Eigen::Vector3d middle_;
  std::vector<std::size_t> chosen_;
};

}  // namespace

double seen_share(const CandidateView& view, std::span<const Eigen::Vector3d> points_in_local) {
  const auto n = std::ranges::count_if(points_in_local,
                                       [&](const Eigen::Vector3d& x) { return sees(view, x); });
  return static_cast<double>(n) / static_cast<double>(points_in_local.size());
}

std::vector<std::size_t> choose_views(std::span<const CandidateView> candidates,
                                      std::span<const Eigen::Vector3d> points_in_local,
                                      double height_range_m,
                                      std::size_t max_views) {
  return Chooser(candidates, points_in_local, height_range_m).choose(max_views);
}

}  // namespace ridgeline::reconstruct
