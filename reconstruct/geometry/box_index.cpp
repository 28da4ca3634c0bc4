// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/box_index.h"

#include "reconstruct/geometry/transformed.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace ridgeline {
namespace {

namespace bg = boost::geometry;

template <int kDim>
using Point = bg::model::point<double, kDim, bg::cs::cartesian>;

Point<2> point(const Eigen::Vector2d& x) { return {x.x(), x.y()}; }
Point<3> point(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

template <int kDim>
bg::model::box<Point<kDim>> rectangle(const Eigen::AlignedBox<double, kDim>& box) {
  return {point(box.min()), point(box.max())};
}

bool is_usable(const auto& box) {
  return !box.isEmpty() && box.min().allFinite() && box.max().allFinite();
}

/// Empty if an end is not finite.
template <int kDim>
Eigen::AlignedBox<double, kDim> box_of(const auto& segment) {
  if (!segment.start.allFinite() || !segment.end.allFinite()) return {};
  return {segment.start.cwiseMin(segment.end), segment.start.cwiseMax(segment.end)};
}

}  // namespace

template <int kDim>
struct BoxIndex<kDim>::Tree {
  using Entry = std::pair<bg::model::box<Point<kDim>>, std::size_t>;

  using Places = bg::index::rtree<Entry, bg::index::rstar<16>>;

  std::vector<Box> boxes;
  Places places;

  explicit Tree(std::span<const Box> all) : boxes(all.begin(), all.end()) {
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (is_usable(boxes[i])) entries.emplace_back(rectangle(boxes[i]), i);
    }
    places = Places(entries.begin(), entries.end());
  }
};

template <int kDim>
BoxIndex<kDim>::BoxIndex(std::span<const Box> boxes) : tree_(std::make_shared<Tree>(boxes)) {}

template <int kDim>
BoxIndex<kDim>::BoxIndex(std::span<const Segment> segments)
    : BoxIndex(transformed(segments, [](const Segment& s) { return box_of<kDim>(s); })) {}

template <int kDim>
std::vector<std::size_t> BoxIndex<kDim>::near(const Box& box, double reach) const {
  std::vector<std::size_t> found;
  if (!tree_ || !is_usable(box)) return found;
  const Box within(box.min().array() - reach, box.max().array() + reach);
  std::vector<typename Tree::Entry> entries;
  tree_->places.query(bg::index::intersects(rectangle(within)), std::back_inserter(entries));
  for (const auto& [place, i] : entries) {
    if (tree_->boxes[i].exteriorDistance(box) <= reach) found.push_back(i);
  }
  std::ranges::sort(found);
  return found;
}

template <int kDim>
std::vector<std::size_t> BoxIndex<kDim>::near(const Segment& segment, double reach) const {
  return near(box_of<kDim>(segment), reach);
}

template class BoxIndex<2>;
template class BoxIndex<3>;

Eigen::AlignedBox2d plan_box_of(std::span<const Eigen::Vector3d> points) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& x : points) {
    if (!x.allFinite()) return {};
    box.extend(x.head<2>());
  }
  return box;
}

}  // namespace ridgeline
