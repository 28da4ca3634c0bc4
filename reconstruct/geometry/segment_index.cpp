// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/segment_index.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kCell_px = 32.0;  // about the length of a segment

Eigen::AlignedBox2d box_of(const Segment2& s) {
  return Eigen::AlignedBox2d(s.start.cwiseMin(s.end), s.start.cwiseMax(s.end));
}

}  // namespace

Eigen::Vector2i SegmentIndex::cell_of(const Eigen::Vector2d& x) const {
  const Eigen::Vector2d last = (n_cells_ - Eigen::Vector2i::Ones()).cast<double>();
  const Eigen::Vector2d cell = ((x - origin_) / kCell_px).array().floor();
  return cell.cwiseMax(0.0).cwiseMin(last).cast<int>();
}

SegmentIndex::SegmentIndex(std::span<const Segment2> segments) {
  if (segments.empty()) return;
  Eigen::AlignedBox2d all;
  for (const Segment2& s : segments) all.extend(box_of(s));
  origin_ = all.min();
  n_cells_ = (all.sizes() / kCell_px).array().floor().cast<int>() + 1;
  const auto for_each_cell = [&](const Segment2& s, const auto& visit) {
    const Eigen::AlignedBox2d box = box_of(s);
    const Eigen::Vector2i low = cell_of(box.min());
    const Eigen::Vector2i high = cell_of(box.max());
    for (int row = low.y(); row <= high.y(); ++row) {
      for (int column = low.x(); column <= high.x(); ++column) {
        const Eigen::Vector2d centre =
            origin_ + kCell_px * (Eigen::Vector2d(column, row) + Eigen::Vector2d::Constant(0.5));
        if (distance(s, centre) <= kCell_px * M_SQRT1_2) visit(row * n_cells_.x() + column);
      }
    }
  };
  first_.assign(static_cast<std::size_t>(n_cells_.prod()) + 1, 0);
  for (const Segment2& s : segments) for_each_cell(s, [&](int cell) { ++first_[cell + 1]; });
  for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
  ids_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t id = 0; id < segments.size(); ++id) {
    for_each_cell(segments[id], [&](int cell) { ids_[next[cell]++] = static_cast<int>(id); });
  }
}

std::vector<int> SegmentIndex::in_box(const Eigen::AlignedBox2d& box) const {
  std::vector<int> found;
  const Eigen::Vector2d far = origin_ + kCell_px * n_cells_.cast<double>();
  if (ids_.empty() || box.isEmpty() || !box.intersects(Eigen::AlignedBox2d(origin_, far))) {
    return found;
  }
  const Eigen::Vector2i low = cell_of(box.min());
  const Eigen::Vector2i high = cell_of(box.max());
  for (int row = low.y(); row <= high.y(); ++row) {
    const std::size_t begin = first_[row * n_cells_.x() + low.x()];
    const std::size_t end = first_[row * n_cells_.x() + high.x() + 1];
    found.insert(found.end(), ids_.begin() + static_cast<std::ptrdiff_t>(begin),
                 ids_.begin() + static_cast<std::ptrdiff_t>(end));
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<int> SegmentIndex::near(const Segment2& segment, double margin_px) const {
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(margin_px);
  const Eigen::AlignedBox2d box = box_of(segment);
  return in_box(Eigen::AlignedBox2d(box.min() - margin, box.max() + margin));
}

}  // namespace ridgeline::reconstruct
