// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/faces/face_index.h"

#include "reconstruct/geometry/plan_box.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::evaluate {

constexpr double kCell_m = 16.0;  // a roof face, as a rule

template <typename Visitor>
void FaceIndex::visit_cells(const Eigen::AlignedBox2d& box, Visitor&& visit) {
  const auto cell_of = [](double x) { return static_cast<long>(std::floor(x / kCell_m)); };
  for (long j = cell_of(box.min().y()); j <= cell_of(box.max().y()); ++j) {
    for (long i = cell_of(box.min().x()); i <= cell_of(box.max().x()); ++i) visit(Cell(i, j));
  }
}

FaceIndex::FaceIndex(std::span<const Eigen::AlignedBox2d> boxes)
    : boxes_(boxes.begin(), boxes.end()) {
  for (std::size_t k = 0; k < boxes_.size(); ++k) {
    if (boxes_[k].isEmpty()) continue;
    visit_cells(boxes_[k], [&](const Cell& cell) { in_cell_[cell].push_back(k); });
  }
}

std::vector<std::size_t> FaceIndex::near(const Eigen::AlignedBox2d& box, double reach_m) const {
  std::vector<std::size_t> found;
  if (box.isEmpty()) return found;
  visit_cells(grown(box, reach_m), [&](const Cell& cell) {
    const auto faces = in_cell_.find(cell);
    if (faces == in_cell_.end()) return;
    for (const std::size_t k : faces->second) {
      if (boxes_[k].exteriorDistance(box) <= reach_m) found.push_back(k);
    }
  });
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace ridgeline::evaluate
