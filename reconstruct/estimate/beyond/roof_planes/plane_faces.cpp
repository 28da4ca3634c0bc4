// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/roof_planes/plane_faces.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

constexpr double kSeed_px = 0.25;       // RMS of three by three cells about their plane
constexpr double kOnPlane_px = 0.4;     // RMS of a cell about the plane of a face
constexpr double kMaxFaceSlope = 0.6;   // change of disparity per pixel; walls are steeper
constexpr double kMinKnownShare = 0.5;  // share of a cell's pixels that have a disparity
constexpr int kMinCells = 12;

/// Moments of pixels (x, y, disparity), from which planes and the distances of the pixels from them
/// are computed. They are taken about the mean, so that a small face far from the first pixel does
/// not lose precision.
struct PlaneSums {
  double n = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector2d& x_px, double d_px) {
    const Eigen::Vector3d pixel(x_px.x(), x_px.y(), d_px);
    n += 1.0;
    const Eigen::Vector3d before = pixel - mean;
    mean += before / n;
    scatter += before * (pixel - mean).transpose();
  }
  PlaneSums& operator+=(const PlaneSums& other) {
    if (other.n == 0.0) return *this;
    const Eigen::Vector3d apart = other.mean - mean;
    const double share = other.n / (n + other.n);
    scatter += other.scatter + n * share * apart * apart.transpose();
    mean += share * apart;
    n += other.n;
    return *this;
  }
  [[nodiscard]] Eigen::Vector3d plane() const {
    const Eigen::Vector2d slope =
        scatter.topLeftCorner<2, 2>().ldlt().solve(scatter.topRightCorner<2, 1>());
    return {slope.x(), slope.y(), mean.z() - slope.dot(mean.head<2>())};
  }
  [[nodiscard]] double rms_px(const Eigen::Vector3d& plane) const {
    const Eigen::Vector3d across(plane.x(), plane.y(), -1.0);
    const double mean_px = across.dot(mean) + plane.z();
    return std::sqrt(std::max(0.0, across.dot(scatter * across)) / n + mean_px * mean_px);
  }
  /// Cofactor matrix of a, b, c for observations of unit weight.
  [[nodiscard]] Eigen::Matrix3d cofactors() const {
    const Eigen::Matrix2d of_slope = scatter.topLeftCorner<2, 2>().inverse();
    Eigen::Matrix<double, 3, 2> by_slope;  // the plane passes through the mean
    by_slope << Eigen::Matrix2d::Identity(), -mean.head<2>().transpose();
    Eigen::Matrix3d all = by_slope * of_slope * by_slope.transpose();
    all(2, 2) += 1.0 / n;
    return all;
  }
};

bool is_steep(const Eigen::Vector3d& plane) { return plane.head<2>().norm() > kMaxFaceSlope; }

class Growing {
 public:
  explicit Growing(const Surface& surface)
      : rows_(surface.disparity_px.rows / PlaneFaces::kCell_px),
        columns_(surface.disparity_px.cols / PlaneFaces::kCell_px),
        cells_(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_)) {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column)
        cell(row, column) = sums(surface, row, column);
    }
    result_.face_of_cell = cv::Mat(rows_, columns_, CV_32S, cv::Scalar(PlaneFaces::kNone));
  }

  PlaneFaces grown() && {
    for (const Seed& seed : seeds()) {
      if (face_of(seed.row, seed.column) < 0) grow(seed);
    }
    return std::move(result_);
  }

 private:
  struct Seed {
    double rms_px;
    int row, column;
  };

  static PlaneSums sums(const Surface& surface, int row, int column) {
    PlaneSums sums;
    for (int y = row * PlaneFaces::kCell_px; y < (row + 1) * PlaneFaces::kCell_px; ++y) {
      for (int x = column * PlaneFaces::kCell_px; x < (column + 1) * PlaneFaces::kCell_px; ++x) {
        if (const auto d = surface.at(Eigen::Vector2d(x, y))) sums.add(Eigen::Vector2d(x, y), *d);
      }
    }
    return sums;
  }

  PlaneSums& cell(int row, int column) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }
  int& face_of(int row, int column) { return result_.face_of_cell.at<int>(row, column); }
  bool is_free(int row, int column) {
    return row >= 0 && column >= 0 && row < rows_ && column < columns_ &&
           face_of(row, column) < 0 &&
           cell(row, column).n >= kMinKnownShare * PlaneFaces::kCell_px * PlaneFaces::kCell_px;
  }

  /// The sum of the three by three cells about a cell; empty unless all of them are free.
  std::optional<PlaneSums> block_about(int row, int column) {
    PlaneSums block;
    for (int r = row - 1; r <= row + 1; ++r) {
      for (int c = column - 1; c <= column + 1; ++c) {
        if (!is_free(r, c)) return std::nullopt;
        block += cell(r, c);
      }
    }
    return block;
  }

  /// Cells from which faces may grow, best first.
  std::vector<Seed> seeds() {
    std::vector<Seed> seeds;
    for (int row = 1; row + 1 < rows_; ++row) {
      for (int column = 1; column + 1 < columns_; ++column) {
        const auto block = block_about(row, column);
        if (!block) continue;
        const Eigen::Vector3d plane = block->plane();
        const double rms_px = block->rms_px(plane);
        if (rms_px <= kSeed_px && !is_steep(plane)) seeds.push_back({rms_px, row, column});
      }
    }
    std::ranges::stable_sort(seeds, {}, &Seed::rms_px);
    return seeds;
  }

  void grow(const Seed& seed) {
    const auto block = block_about(seed.row, seed.column);
    if (!block) return;
    PlaneSums all = *block;
    Eigen::Vector3d plane = all.plane();
    const auto index = static_cast<int>(result_.faces.size());
    std::deque<std::pair<int, int>> border;
    std::vector<std::pair<int, int>> members;
    const auto take = [&](int row, int column) {
      face_of(row, column) = index;
      border.emplace_back(row, column);
      members.emplace_back(row, column);
    };
    for (int r = seed.row - 1; r <= seed.row + 1; ++r) {
      for (int c = seed.column - 1; c <= seed.column + 1; ++c) take(r, c);
    }
    while (!border.empty()) {
      const auto [row, column] = border.front();
      border.pop_front();
      for (const auto& [r, c] : {std::pair(row - 1, column), std::pair(row + 1, column),
                                 std::pair(row, column - 1), std::pair(row, column + 1)}) {
        if (!is_free(r, c) || cell(r, c).rms_px(plane) > kOnPlane_px) continue;
        take(r, c);
        all += cell(r, c);
        plane = all.plane();
      }
    }
    const PlaneSums inner = inner_sums(members, index);
    if (inner.n > 0.0) plane = inner.plane();
    if (static_cast<int>(members.size()) < kMinCells || inner.n == 0.0 || is_steep(plane)) {
      for (const auto& [row, column] : members) face_of(row, column) = PlaneFaces::kNone;
      return;
    }
    result_.faces.push_back({plane, covariance(inner, plane), static_cast<int>(members.size())});
  }

  /// Sums over the cells of a face whose neighbours all belong to it, because cells on its border
  /// may include pixels beyond it.
  PlaneSums inner_sums(const std::vector<std::pair<int, int>>& members, int index) {
    PlaneSums inner;
    const auto is_member = [&](int row, int column) {
      return row >= 0 && column >= 0 && row < rows_ && column < columns_ &&
             face_of(row, column) == index;
    };
    for (const auto& [row, column] : members) {
      if (is_member(row - 1, column) && is_member(row + 1, column) && is_member(row, column - 1) &&
          is_member(row, column + 1))
        inner += cell(row, column);
    }
    return inner;
  }

  /// Covariance of a plane. It allows for errors common to neighbours, because the matching
  /// smooths.
  static Eigen::Matrix3d covariance(const PlaneSums& all, const Eigen::Vector3d& plane) {
    constexpr double kTogether = 100.0;  // number of pixels with a common error
    constexpr double kMinSigma_px = 0.05;
    const double sigma_px = std::max(kMinSigma_px, all.rms_px(plane));
    return kTogether * sigma_px * sigma_px * all.cofactors();
  }

  int rows_, columns_;
  std::vector<PlaneSums> cells_;
  PlaneFaces result_;
};

}  // namespace

int PlaneFaces::at(const Eigen::Vector2d& x_px) const {
  const Eigen::Array2d cell = ((x_px.array() + 0.5) / PlaneFaces::kCell_px).floor();
  const bool is_inside =
      (cell >= 0.0).all() && cell.x() < face_of_cell.cols && cell.y() < face_of_cell.rows;
  return is_inside ? face_of_cell.at<int>(static_cast<int>(cell.y()), static_cast<int>(cell.x()))
                   : kNone;
}

PlaneFaces plane_faces(const Surface& surface) { return Growing(surface).grown(); }

}  // namespace ridgeline::reconstruct
