// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/merge_planes.h"

#include "evaluate/faces/plan_polygon.h"
#include "reconstruct/geometry/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::PlanPolygon;
using evaluate::ScanPlane;
using Ring = std::vector<Eigen::Vector3d>;

/// A plane of a cell.
struct PlaneOfCell {
  const ScanPlane* plane = nullptr;
  std::size_t cell = 0;  ///< number in the list
  PlanPolygon outline;
  bool is_cut = false;
};

bool is_inside(const Eigen::AlignedBox2d& box, const Eigen::Vector3d& x) {
  return box.contains(x.head<2>());
}

PlaneOfCell plane_of_cell(const ScanPlane& plane,
                          std::size_t number,
                          const Eigen::AlignedBox2d& seen) {
  PlaneOfCell of_cell{.plane = &plane, .cell = number, .outline = PlanPolygon(plane.rings)};
  const Eigen::AlignedBox2d& box = of_cell.outline.box();
  const Eigen::Vector2d reach_m = Eigen::Vector2d::Constant(kCutReach_m);
  of_cell.is_cut = !box.isEmpty() &&
                   !Eigen::AlignedBox2d(seen.min() + reach_m, seen.max() - reach_m).contains(box);
  return of_cell;
}

/// Whether half of the outline of `a` in the box lies on `b`.
bool lies_on(const PlaneOfCell& a, const PlaneOfCell& b, const Eigen::AlignedBox2d& both_see) {
  constexpr double kHeight_m = 0.15;
  constexpr double kBeside_m = 1.0;
  if (a.plane->rings.empty() || b.plane->rings.empty()) return false;
  std::size_t n = 0;
  std::size_t n_on = 0;
  for (const Eigen::Vector3d& x : a.plane->rings.front()) {
    if (!is_inside(both_see, x)) continue;
    ++n;
    if (b.plane->fit.plane.absDistance(x) > kHeight_m) continue;
    if (b.outline.distance_m(x.head<2>()) <= kBeside_m) ++n_on;
  }
  return 2 * n_on > n;
}

bool is_same(const PlaneOfCell& a, const PlaneOfCell& b, const Eigen::AlignedBox2d& both_see) {
  constexpr double kMaxAngle_rad = 5.0 * std::numbers::pi / 180.0;
  if (!a.outline.box().intersects(b.outline.box())) return false;
  const double cosine = a.plane->fit.plane.normal().dot(b.plane->fit.plane.normal());
  if (std::abs(cosine) < std::cos(kMaxAngle_rad)) return false;
  return lies_on(a, b, both_see) || lies_on(b, a, both_see);
}

/// The part of a ring at which sign * x[axis] <= sign * limit, by Sutherland and Hodgman (1974).
Ring cut(const Ring& ring, int axis, double limit, double sign) {
  Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector3d& a = ring[i];
    const Eigen::Vector3d& b = ring[(i + 1) % ring.size()];
    const double beyond_a = sign * (a[axis] - limit);
    const double beyond_b = sign * (b[axis] - limit);
    if (beyond_a <= 0.0) kept.push_back(a);
    if ((beyond_a < 0.0 && beyond_b > 0.0) || (beyond_a > 0.0 && beyond_b < 0.0)) {
      Eigen::Vector3d x = a + beyond_a / (beyond_a - beyond_b) * (b - a);
      x[axis] = limit;
      kept.push_back(x);
    }
  }
  return kept;
}

std::vector<Ring> cut(const std::vector<Ring>& rings, const Eigen::AlignedBox2d& box) {
  std::vector<Ring> kept;
  for (const Ring& ring : rings) {
    Ring part = ring;
    for (const int axis : {0, 1}) {
      part = cut(part, axis, box.max()[axis], 1.0);
      part = cut(part, axis, box.min()[axis], -1.0);
    }
    if (part.size() >= 3) kept.push_back(std::move(part));
  }
  return kept;
}

/// The part of a plane in its own cell.
ScanPlane part_in_cell(const PlaneOfCell& of_cell, const Eigen::AlignedBox2d& box) {
  ScanPlane part = *of_cell.plane;
  part.rings = cut(part.rings, box);
  const double whole_m2 = of_cell.outline.area_m2();
  const double part_m2 = PlanPolygon(part.rings).area_m2();
  part.area_m2 = whole_m2 > 0.0 ? part.area_m2 * part_m2 / whole_m2 : 0.0;
  return part;
}

class PlaneMerge {
 public:
  PlaneMerge(const std::vector<FoundInCell>& cells, const MapCell& base)
      : cells_(cells), base_(base) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      first_.push_back(planes_.size());
      const Eigen::AlignedBox2d seen = box_of(cells[i].cell, base, kCellMargin_m);
      for (const ScanPlane& plane : cells[i].found.planes) {
        planes_.push_back(plane_of_cell(plane, i, seen));
      }
    }
    first_.push_back(planes_.size());
  }

  MergedPlanes merge() {
    DisjointSets sets(planes_.size());
    for_each_neighbours(cells_, [&](std::size_t i, std::size_t k) { join_same(i, k, sets); });
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t p = 0; p < planes_.size(); ++p) members[sets.name_of(p)].push_back(p);
    MergedPlanes merged;
    std::vector<std::size_t> index(planes_.size());
    for (const auto& [name, same] : members) {
      for (const std::size_t p : same) index[p] = merged.planes.size();
      merged.planes.push_back(one_of(same));
    }
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      merged.index.emplace_back(index.begin() + static_cast<std::ptrdiff_t>(first_[i]),
                                index.begin() + static_cast<std::ptrdiff_t>(first_[i + 1]));
    }
    return merged;
  }

 private:
  void join_same(std::size_t i, std::size_t k, DisjointSets& sets) const {
    const Eigen::AlignedBox2d both_see =
        box_of(cells_[i].cell, base_, kCellMargin_m)
            .intersection(box_of(cells_[k].cell, base_, kCellMargin_m));
    for (std::size_t a = first_[i]; a < first_[i + 1]; ++a) {
      if (!planes_[a].outline.box().intersects(both_see)) continue;
      for (std::size_t b = first_[k]; b < first_[k + 1]; ++b) {
        if (is_same(planes_[a], planes_[b], both_see)) sets.join(a, b);
      }
    }
  }

  [[nodiscard]] Eigen::AlignedBox2d own_box(const PlaneOfCell& plane) const {
    return box_of(cells_[plane.cell].cell, base_, 0.0);
  }

  /// One plane for those that are the same: a whole one, best with its centroid in its own cell;
  /// otherwise the parts in all cells.
  [[nodiscard]] MergedPlanes::Plane one_of(const std::vector<std::size_t>& same) const {
    constexpr double kOfNeither_m =
        2.0;  // a centroid that two cells see on either side of a border
    const PlaneOfCell* best = nullptr;
    double least_m = 0.0;
    for (const std::size_t p : same) {
      if (planes_[p].is_cut) continue;
      const double outside_m =
          own_box(planes_[p]).exteriorDistance(planes_[p].plane->fit.centroid.head<2>());
      if (best != nullptr && least_m <= outside_m) continue;
      best = &planes_[p];
      least_m = outside_m;
    }
    if (best != nullptr) return {*best->plane, least_m <= kOfNeither_m};
    return joined(same);
  }

  [[nodiscard]] MergedPlanes::Plane joined(const std::vector<std::size_t>& same) const {
    MergedPlanes::Plane merged;
    std::vector<Ring> rings;
    double area_m2 = 0.0;
    double largest_m2 = -1.0;
    for (const std::size_t p : same) {
      const ScanPlane part = part_in_cell(planes_[p], own_box(planes_[p]));
      area_m2 += part.area_m2;
      rings.insert(rings.end(), part.rings.begin(), part.rings.end());
      if (part.area_m2 <= largest_m2) continue;
      largest_m2 = part.area_m2;
      merged.plane = *planes_[p].plane;
    }
    merged.belongs = !rings.empty();
    if (!merged.belongs) return merged;
    merged.plane.rings = std::move(rings);
    merged.plane.area_m2 = area_m2;
    return merged;
  }

  const std::vector<FoundInCell>& cells_;
  MapCell base_;
  std::vector<PlaneOfCell> planes_;
  std::vector<std::size_t> first_;  ///< of each cell, then the number of planes
};

}  // namespace

std::map<MapCell, std::size_t> numbers_of(const std::vector<FoundInCell>& cells) {
  std::map<MapCell, std::size_t> numbers;
  for (std::size_t i = 0; i < cells.size(); ++i) numbers.emplace(cells[i].cell, i);
  return numbers;
}

MergedPlanes merge_planes(const std::vector<FoundInCell>& cells, const MapCell& base) {
  return PlaneMerge(cells, base).merge();
}

}  // namespace ridgeline::results
