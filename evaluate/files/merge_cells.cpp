// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/merge_cells.h"

#include "evaluate/files/merge_planes.h"
#include "reconstruct/geometry/disjoint_sets.h"

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::ScanEdge;
using evaluate::ScanEdges;

constexpr double kSameLine_m = 0.3;
constexpr double kSameDirection_rad = 3.0 * std::numbers::pi / 180.0;
/// By how much the pieces of two cells overlap: their common border then needs no exact match.
constexpr double kOverlap_m = 1.0;

/// An edge of a cell: whole, or its piece in the cell.
struct EdgeOfCell {
  ScanEdge edge;
  std::size_t cell = 0;  ///< number in the list
  bool is_whole = false;
  double outside_m = 0.0;  ///< distance of its middle from its cell
};

Eigen::AlignedBox2d grown(const Eigen::AlignedBox2d& box, double by_m) {
  const Eigen::Vector2d margin_m = Eigen::Vector2d::Constant(by_m);
  return {box.min() - margin_m, box.max() + margin_m};
}

/// The part of a segment in a box in plan; std::nullopt if there is none.
std::optional<Segment3> part_in(const Segment3& segment, const Eigen::AlignedBox2d& box) {
  double from = 0.0;
  double to = 1.0;
  for (const int axis : {0, 1}) {
    const double start = segment.start[axis];
    const double run = segment.end[axis] - start;
    if (run == 0.0) {
      if (start < box.min()[axis] || start > box.max()[axis]) return std::nullopt;
      continue;
    }
    const auto [enters, leaves] =
        std::minmax({(box.min()[axis] - start) / run, (box.max()[axis] - start) / run});
    from = std::max(from, enters);
    to = std::min(to, leaves);
  }
  if (from >= to) return std::nullopt;
  return Segment3{point_at(segment, from), point_at(segment, to)};
}

/// The share that a cell has in an edge that it found; std::nullopt if none.
std::optional<EdgeOfCell> share_of(const ScanEdge& edge,
                                   std::size_t cell,
                                   const Eigen::AlignedBox2d& own) {
  constexpr double kOfNeither_m = 2.0;  // a middle that two cells see on either side of a border
  constexpr double kShortestPiece_m = 1.5;
  const Eigen::AlignedBox2d certain = grown(own, kCellMargin_m - kCutReach_m);
  const Segment2 in_plan = plan(edge.segment);
  EdgeOfCell share{.edge = edge, .cell = cell};
  share.outside_m = own.exteriorDistance(midpoint(in_plan));
  share.is_whole = certain.contains(in_plan.start) && certain.contains(in_plan.end);
  if (share.is_whole) {
    return share.outside_m <= kOfNeither_m ? std::optional(share) : std::nullopt;
  }
  const std::optional<Segment3> piece = part_in(edge.segment, grown(own, kOverlap_m));
  if (!piece || length(*piece) < kShortestPiece_m) return std::nullopt;
  share.edge.segment = *piece;
  return share;
}

/// How two segments lie along each other.
struct Along {
  double overlap_m = 0.0;  ///< negative: the gap between them
  double shorter_m = 0.0;
  double apart_m = 0.0;  ///< of the ends of the overlap or gap from the other line, the largest
};

/// std::nullopt if their directions differ.
std::optional<Along> along(const Segment3& a, const Segment3& b) {
  const bool a_is_longer = length(a) >= length(b);
  const Segment3& longer = a_is_longer ? a : b;
  const Segment3& shorter = a_is_longer ? b : a;
  const Eigen::Vector3d run = longer.end - longer.start;
  if (acute_angle_rad(run, Eigen::Vector3d(shorter.end - shorter.start)) > kSameDirection_rad)
    return std::nullopt;
  const double length_m = run.norm();
  const double t_start = parameter_along(longer, shorter.start);
  const double t_end = parameter_along(longer, shorter.end);
  const auto [low, high] = std::minmax(t_start, t_end);
  Along result{.overlap_m = (std::min(high, 1.0) - std::max(low, 0.0)) * length_m,
               .shorter_m = length(shorter)};
  // The places on the shorter one that are nearest to the ends of the common part.
  for (const double t : {std::max(low, 0.0), std::min(high, 1.0)}) {
    const double share = std::clamp((t - t_start) / (t_end - t_start), 0.0, 1.0);
    const Eigen::Vector3d x = point_at(shorter, share);
    const Eigen::Vector3d foot = point_at(longer, parameter_along(longer, x));
    result.apart_m = std::max(result.apart_m, (x - foot).norm());
  }
  return result;
}

bool is_same(const EdgeOfCell& a, const EdgeOfCell& b) {
  constexpr double kLargestGap_m = 1.0;
  const std::optional<Along> lie = along(a.edge.segment, b.edge.segment);
  if (!lie || lie->apart_m > kSameLine_m) return false;
  if (2.0 * lie->overlap_m >= lie->shorter_m) return true;
  return !a.is_whole && !b.is_whole && a.edge.kind == b.edge.kind &&
         lie->overlap_m >= -kLargestGap_m;
}

/// Of the same edge seen by several cells: the whole ones of one cell, best the cell of their
/// middle.
std::vector<const EdgeOfCell*> whole_ones(const std::vector<const EdgeOfCell*>& same) {
  std::vector<const EdgeOfCell*> whole;
  for (const EdgeOfCell* edge : same) {
    if (edge->is_whole) whole.push_back(edge);
  }
  if (whole.empty()) return whole;
  const EdgeOfCell* const best = *std::ranges::min_element(
      whole, {}, [](const EdgeOfCell* e) { return std::pair(e->outside_m, e->cell); });
  std::erase_if(whole, [&](const EdgeOfCell* e) { return e->cell != best->cell; });
  return whole;
}

/// An end of a piece.
struct PieceEnd {
  const EdgeOfCell* piece;
  bool is_end;  ///< otherwise the start
  double at;    ///< along the longest piece

  [[nodiscard]] const Eigen::Vector3d& place() const {
    return is_end ? piece->edge.segment.end : piece->edge.segment.start;
  }
  [[nodiscard]] Eigen::Matrix3d covariance_m2() const {
    const int first = is_end ? 3 : 0;
    return piece->edge.covariance_m2.block<3, 3>(first, first);
  }
};

/// One edge of the pieces of several cells.
EdgeOfCell joined(const std::vector<const EdgeOfCell*>& pieces) {
  EdgeOfCell edge = **std::ranges::max_element(
      pieces, {}, [](const EdgeOfCell* piece) { return length(piece->edge.segment); });
  std::vector<PieceEnd> ends;
  double total_m = 0.0;
  double supported_m = 0.0;
  double moved_m2 = 0.0;
  for (const EdgeOfCell* piece : pieces) {
    const Segment3& s = piece->edge.segment;
    ends.push_back({piece, false, parameter_along(edge.edge.segment, s.start)});
    ends.push_back({piece, true, parameter_along(edge.edge.segment, s.end)});
    total_m += length(s);
    supported_m += piece->edge.support * length(s);
    moved_m2 += piece->edge.moved_out_m * length(s);
  }
  const auto [first, last] = std::ranges::minmax(ends, {}, &PieceEnd::at);
  edge.edge.segment = {first.place(), last.place()};
  if (pieces.size() > 1) {
    edge.edge.covariance_m2.setZero();
    edge.edge.covariance_m2.topLeftCorner<3, 3>() = first.covariance_m2();
    edge.edge.covariance_m2.bottomRightCorner<3, 3>() = last.covariance_m2();
  }
  edge.edge.support = supported_m / total_m;
  edge.edge.moved_out_m = moved_m2 / total_m;
  return edge;
}

/// The edges of all cells, each with the number of its cell, in the order of the cells.
std::vector<EdgeOfCell> merge_edges(const std::vector<FoundInCell>& cells, const MapCell& base) {
  std::vector<EdgeOfCell> shares;
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    first.push_back(shares.size());
    const Eigen::AlignedBox2d own = box_of(cells[i].cell, base, 0.0);
    for (const ScanEdge& edge : cells[i].found.edges) {
      if (auto share = share_of(edge, i, own)) shares.push_back(std::move(*share));
    }
  }
  first.push_back(shares.size());
  DisjointSets sets(shares.size());
  for_each_neighbours(cells, [&](std::size_t i, std::size_t k) {
    for (std::size_t a = first[i]; a < first[i + 1]; ++a) {
      for (std::size_t b = first[k]; b < first[k + 1]; ++b) {
        if (is_same(shares[a], shares[b])) sets.join(a, b);
      }
    }
  });
  std::map<std::size_t, std::vector<const EdgeOfCell*>> groups;
  for (std::size_t e = 0; e < shares.size(); ++e) groups[sets.name_of(e)].push_back(&shares[e]);
  std::vector<EdgeOfCell> merged;
  for (const auto& [name, same] : groups) {
    const std::vector<const EdgeOfCell*> whole = whole_ones(same);
    for (const EdgeOfCell* edge : whole) merged.push_back(*edge);
    if (whole.empty()) merged.push_back(joined(same));
  }
  std::ranges::stable_sort(merged, {}, &EdgeOfCell::cell);
  return merged;
}

}  // namespace

Eigen::AlignedBox2d box_of(const MapCell& cell, const MapCell& base, double margin_m) {
  const Eigen::Vector2d corner(static_cast<double>((cell.column - base.column) * kCell_m),
                               static_cast<double>((cell.row - base.row) * kCell_m));
  const Eigen::Vector2d size_m = Eigen::Vector2d::Constant(static_cast<double>(kCell_m));
  return grown({corner, corner + size_m}, margin_m);
}

ScanEdges merge_cells(std::vector<FoundInCell> cells, const MapCell& base) {
  std::ranges::sort(cells, {}, &FoundInCell::cell);
  MergedPlanes planes = merge_planes(cells, base);
  std::vector<EdgeOfCell> edges = merge_edges(cells, base);
  for (EdgeOfCell& edge : edges) {
    for (std::size_t& plane : edge.edge.planes) {
      plane = planes.index[edge.cell][plane];
      planes.planes[plane].belongs = true;
    }
  }
  ScanEdges merged;
  std::vector<std::size_t> index(planes.planes.size());
  for (std::size_t p = 0; p < planes.planes.size(); ++p) {
    index[p] = merged.planes.size();
    if (planes.planes[p].belongs) merged.planes.push_back(std::move(planes.planes[p].plane));
  }
  for (EdgeOfCell& edge : edges) {
    for (std::size_t& plane : edge.edge.planes) plane = index[plane];
    merged.edges.push_back(std::move(edge.edge));
  }
  return merged;
}

}  // namespace ridgeline::results
