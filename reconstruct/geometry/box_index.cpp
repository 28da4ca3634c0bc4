// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/box_index.h"

#include "reconstruct/geometry/plan_box.h"

#include <algorithm>
#include <cmath>

namespace ridgeline {
namespace {

constexpr double kCell = 16.0;  // a roof face in metres, as a rule

/// The range of cells of a box.
struct Cells {
  Eigen::Vector2d low, high;

  explicit Cells(const Eigen::AlignedBox2d& box)
      : low((box.min() / kCell).array().floor()), high((box.max() / kCell).array().floor()) {}

  [[nodiscard]] bool are_many() const {
    constexpr double kMaxCells = 4096.0;
    constexpr double kMaxCoordinate = 1e15;  // beyond it cells are no integers
    const Eigen::Vector2d n = high - low + Eigen::Vector2d::Ones();
    return !(n.prod() <= kMaxCells) || low.cwiseAbs().maxCoeff() > kMaxCoordinate ||
           high.cwiseAbs().maxCoeff() > kMaxCoordinate;
  }

  template <typename Visitor>
  void visit(Visitor visit) const {
    for (auto i = static_cast<long>(low.x()); i <= static_cast<long>(high.x()); ++i)
      for (auto j = static_cast<long>(low.y()); j <= static_cast<long>(high.y()); ++j) visit(i, j);
  }
};

}  // namespace

BoxIndex::BoxIndex(std::vector<Eigen::AlignedBox2d> boxes) : boxes_(std::move(boxes)) {
  for (std::size_t k = 0; k < boxes_.size(); ++k) {
    const Eigen::AlignedBox2d& box = boxes_[k];
    if (box.isEmpty() || !box.min().allFinite() || !box.max().allFinite()) continue;
    const Cells cells(box);
    if (cells.are_many()) {
      wide_.push_back(k);
      continue;
    }
    cells.visit([&](long i, long j) { in_cell_[{i, j}].push_back(k); });
  }
}

std::vector<std::size_t> BoxIndex::near(const Eigen::AlignedBox2d& box, double reach) const {
  std::vector<std::size_t> found;
  if (box.isEmpty() || !box.min().allFinite() || !box.max().allFinite()) return found;
  const auto add = [&](const std::vector<std::size_t>& candidates) {
    for (const std::size_t k : candidates)
      if (boxes_[k].exteriorDistance(box) <= reach) found.push_back(k);
  };
  const Cells cells(grown(box, reach));
  if (cells.are_many()) {
    for (const auto& [cell, candidates] : in_cell_) add(candidates);
  } else {
    cells.visit([&](long i, long j) {
      const auto candidates = in_cell_.find({i, j});
      if (candidates != in_cell_.end()) add(candidates->second);
    });
  }
  add(wide_);
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

Eigen::AlignedBox2d plan_box_of(std::span<const Eigen::Vector3d> points) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& x : points) {
    if (!x.allFinite()) return {};
    box.extend(x.head<2>());
  }
  return box;
}

}  // namespace ridgeline
