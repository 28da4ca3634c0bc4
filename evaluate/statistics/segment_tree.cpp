// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/statistics/segment_tree.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <utility>

namespace ridgeline::evaluate {
namespace {

namespace bg = boost::geometry;

template <typename Segment>
using Point =
    bg::model::point<double, decltype(Segment::start)::RowsAtCompileTime, bg::cs::cartesian>;

Point<Segment2> point(const Eigen::Vector2d& x) { return {x.x(), x.y()}; }
Point<Segment3> point(const Eigen::Vector3d& x) { return {x.x(), x.y(), x.z()}; }

bool is_finite(const auto& segment) { return segment.start.allFinite() && segment.end.allFinite(); }

template <typename Segment>
bg::model::box<Point<Segment>> box_around(const Segment& s, double margin) {
  const decltype(Segment::start) low = s.start.cwiseMin(s.end).array() - margin;
  const decltype(Segment::start) high = s.start.cwiseMax(s.end).array() + margin;
  return {point(low), point(high)};
}

}  // namespace

template <typename Segment>
struct SegmentTree<Segment>::Boxes {
  using Entry = std::pair<bg::model::box<Point<Segment>>, std::size_t>;
  explicit Boxes(const std::vector<Entry>& entries) : tree(entries) {}
  bg::index::rtree<Entry, bg::index::rstar<16>> tree;
};

template <typename Segment>
SegmentTree<Segment>::SegmentTree(std::span<const Segment> segments) {
  std::vector<typename Boxes::Entry> entries;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (is_finite(segments[i])) entries.emplace_back(box_around(segments[i], 0.0), i);
  }
  boxes_ = std::make_shared<const Boxes>(entries);
}

template <typename Segment>
std::vector<std::size_t> SegmentTree<Segment>::near(const Segment& segment, double reach) const {
  std::vector<std::size_t> found;
  if (!is_finite(segment)) return found;
  const auto& tree = boxes_->tree;
  for (auto it = tree.qbegin(bg::index::intersects(box_around(segment, reach))); it != tree.qend();
       ++it) {
    found.push_back(it->second);
  }
  std::sort(found.begin(), found.end());
  return found;
}

template class SegmentTree<Segment2>;
template class SegmentTree<Segment3>;

}  // namespace ridgeline::evaluate
