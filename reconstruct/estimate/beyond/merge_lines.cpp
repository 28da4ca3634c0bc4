// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/merge_lines.h"

#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/plan_box.h"
#include "reconstruct/geometry/transformed.h"

#include <Eigen/Dense>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

/// Parameters from..to along a line, 0 at its start and 1 at its end; empty if from >= to.
struct LinePart {
  double from = 0.0, to = 1.0;
  [[nodiscard]] double share() const { return std::max(to - from, 0.0); }
};

/// The part of a stretch of the segment that lies in a box in plan.
LinePart within(const Segment3& segment, const Eigen::AlignedBox2d& box, LinePart stretch) {
  const Eigen::Vector2d start = segment.start.head<2>();
  const Eigen::Vector2d way = (segment.end - segment.start).head<2>();
  for (int axis = 0; axis < 2; ++axis) {
    if (way[axis] == 0.0) {
      if (start[axis] < box.min()[axis] || start[axis] > box.max()[axis]) return {0.0, 0.0};
      continue;
    }
    const double a = (box.min()[axis] - start[axis]) / way[axis];
    const double b = (box.max()[axis] - start[axis]) / way[axis];
    stretch = {std::max(stretch.from, std::min(a, b)), std::min(stretch.to, std::max(a, b))};
  }
  return stretch;
}

/// The part of `a` that lies beside `b`.
LinePart beside(const Segment3& a, const Segment3& b, LinePart stretch) {
  const double start = parameter_along(a, b.start);
  const double end = parameter_along(a, b.end);
  return {std::max(stretch.from, std::min(start, end)), std::min(stretch.to, std::max(start, end))};
}

/// Covariance of the point at a parameter, which may lie beyond the ends.
Eigen::Matrix3d covariance_at(const UncertainLine& line, double t) {
  Eigen::Matrix<double, 3, 6> J;
  J << (1.0 - t) * Eigen::Matrix3d::Identity(), t * Eigen::Matrix3d::Identity();
  return J * line.covariance_m2 * J.transpose();
}

/// Two unit vectors across a direction.
Eigen::Matrix<double, 2, 3> across(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d first = direction.unitOrthogonal();
  Eigen::Matrix<double, 2, 3> axes;
  axes << first.transpose(), direction.normalized().cross(first).transpose();
  return axes;
}

/// Squared distances of the ends of `shorter` across `longer`, normalised by their covariances;
/// four degrees of freedom. The correlation of the two ends is neglected because it is low.
double squared_difference(const UncertainLine& longer, const UncertainLine& shorter) {
  const Segment3& along = longer.segment_in_world;
  const auto axes = across(along.end - along.start);
  double sum = 0.0;
  for (const double s : {0.0, 1.0}) {
    const Eigen::Vector3d x = point_at(shorter.segment_in_world, s);
    const double t = parameter_along(along, x);
    const Eigen::Vector2d offset = axes * (x - point_at(along, t));
    const Eigen::Matrix2d covariance =
        axes * (covariance_at(longer, t) + covariance_at(shorter, s)) * axes.transpose();
    sum += offset.dot(covariance.ldlt().solve(offset));
  }
  return sum;
}

constexpr double kReach_m =
    1.0;  // lines farther apart in plan are never duplicates, whatever their covariances

bool is_within_reach(const Segment3& longer, const Segment3& shorter) {
  return std::ranges::all_of(std::array{shorter.start, shorter.end}, [&](const Eigen::Vector3d& x) {
    const Eigen::Vector3d foot = point_at(longer, parameter_along(longer, x));
    return (x - foot).head<2>().norm() <= kReach_m;
  });
}

/// Probability that chi-square with four degrees of freedom exceeds a value.
double chi_square_tail(double value) { return std::exp(-0.5 * value) * (1.0 + 0.5 * value); }

/// A duplicate of a line, and whether it runs the other way.
struct Duplicate {
  std::size_t line = 0;
  bool reversed = false;
};

class Merger {
 public:
  Merger(std::span<const FoundLine> lines, const PatchGrid& grid, const MergeOptions& options)
      : lines_(lines), grid_(grid), options_(options), twins_(lines.size()) {
    owners_ = transformed(lines, [&](const FoundLine& found) {
      return grid.cell_of(midpoint(found.line.segment_in_world).head<2>());
    });
    find_twins();
  }

  /// The lines that are tied to one of these by a chain of duplicates of any length.
  [[nodiscard]] std::vector<bool> tied_to(const std::vector<bool>& these) const {
    std::vector<bool> is_tied = these;
    std::vector<std::size_t> next;
    for (std::size_t i = 0; i < these.size(); ++i)
      if (these[i]) next.push_back(i);
    while (!next.empty()) {
      const std::size_t i = next.back();
      next.pop_back();
      for (const Duplicate& duplicate : twins_[i]) {
        if (is_tied[duplicate.line]) continue;
        is_tied[duplicate.line] = true;
        next.push_back(duplicate.line);
      }
    }
    return is_tied;
  }

  /// The merged lines of all lines except those of `is_left`, which have no duplicate among the
  /// others.
  [[nodiscard]] std::vector<MergedLine> merge(const std::vector<bool>& is_left) const {
    std::vector<bool> is_taken = is_left;  // as a line or as part of one
    std::vector<MergedLine> merged;
    for (const std::size_t i : in_order_of_choice()) {
      if (is_taken[i] || !counts(i)) continue;
      take(i, is_taken);
      merged.push_back(merged_line(i, is_taken));
    }
    return merged;
  }

 private:
  void find_twins() {
    const Eigen::Vector2d origin =
        lines_.empty() ? Eigen::Vector2d::Zero()
                       : Eigen::Vector2d(lines_[0].line.segment_in_world.start.head<2>());
    const std::vector<Segment2> plans = transformed(lines_, [&](const FoundLine& found) {
      const Segment2 seen = plan(found.line.segment_in_world);
      return Segment2{seen.start - origin, seen.end - origin};
    });
    const BoxIndex2 index(plans);
    tbb::parallel_for(std::size_t{0}, lines_.size(), [&](std::size_t i) {
      for (const std::size_t j : index.near(plans[i], kReach_m)) {
        if (const auto duplicate = twin_of(i, j)) twins_[i].push_back(*duplicate);
      }
    });
  }

  [[nodiscard]] Eigen::AlignedBox2d covered(const GridCell& cell) const {
    return grown(grid_.square(cell), options_.overlap_m);
  }

  [[nodiscard]] std::optional<Duplicate> twin_of(std::size_t i, std::size_t j) const {
    if (lines_[i].cell == lines_[j].cell) return std::nullopt;
    const Eigen::AlignedBox2d both = covered(lines_[i].cell).intersection(covered(lines_[j].cell));
    if (both.isEmpty()) return std::nullopt;
    // The relation must not depend on the order of the two lines.
    const bool i_is_longer = std::tuple(length(segment(i)), i) > std::tuple(length(segment(j)), j);
    const std::size_t a = i_is_longer ? i : j;
    const std::size_t b = i_is_longer ? j : i;
    const LinePart shown_a = within(segment(a), both, {});
    const LinePart shown_b = within(segment(b), both, {});
    const LinePart common = beside(segment(a), segment(b), shown_a);
    const double shorter_m =
        std::min(shown_a.share() * length(segment(a)), shown_b.share() * length(segment(b)));
    const double common_m = common.share() * length(segment(a));
    if (!(common_m > 0.0) || common_m < kMinCommonShare * shorter_m) return std::nullopt;
    if (!is_within_reach(segment(a), segment(b))) return std::nullopt;
    const double difference = squared_difference(lines_[a].line, lines_[b].line);
    if (chi_square_tail(difference) < options_.significance) return std::nullopt;
    const bool reversed =
        (segment(i).end - segment(i).start).dot(segment(j).end - segment(j).start) < 0.0;
    return Duplicate{j, reversed};
  }

  [[nodiscard]] const Segment3& segment(std::size_t i) const {
    return lines_[i].line.segment_in_world;
  }

  [[nodiscard]] bool is_owned(std::size_t i) const { return owners_[i] == lines_[i].cell; }

  /// Whether the patch of the square that a line belongs to found the line or a duplicate of it.
  [[nodiscard]] bool counts(std::size_t i) const {
    return is_owned(i) || std::ranges::any_of(twins_[i], [&](const Duplicate& duplicate) {
             return lines_[duplicate.line].cell == owners_[i];
           });
  }

  /// Lines found by the patch of their own square come first, then the longest ones.
  [[nodiscard]] std::vector<std::size_t> in_order_of_choice() const {
    std::vector<std::size_t> order(lines_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) {
      return std::tuple(!is_owned(i), -length(segment(i)), lines_[i].cell, i);
    });
    return order;
  }

  void take(std::size_t i, std::vector<bool>& is_taken) const {
    is_taken[i] = true;
    for (const Duplicate& duplicate : twins_[i]) is_taken[duplicate.line] = true;
  }

  [[nodiscard]] MergedLine merged_line(std::size_t i, std::vector<bool>& is_taken) const {
    MergedLine merged{i, lines_[i].cell, lines_[i].line};
    prolong(i, false, merged.geometry, is_taken);
    prolong(i, true, merged.geometry, is_taken);
    return merged;
  }

  /// Takes the end of the line from its duplicates, and from their duplicates in turn, as long as
  /// it lies beyond the square of the patch that it comes from.
  void prolong(std::size_t i,
               bool at_start,
               UncertainLine& line,
               std::vector<bool>& is_taken) const {
    Segment3& whole = line.segment_in_world;
    std::size_t from = i;
    bool reversed = false;  // `from` relative to `i`
    while (grid_.cell_of((at_start ? whole.start : whole.end).head<2>()) != lines_[from].cell) {
      std::optional<Duplicate> farthest;
      double reach = at_start ? 0.0 : 1.0;
      for (const Duplicate& duplicate : twins_[from]) {
        const bool turned = reversed != duplicate.reversed;
        const double t = parameter_along(whole, end_of(duplicate.line, at_start != turned));
        if (at_start ? t >= reach : t <= reach) continue;
        reach = t;
        farthest = duplicate;
      }
      if (!farthest) return;
      reversed = reversed != farthest->reversed;
      from = farthest->line;
      take(from, is_taken);
      take_end(from, at_start, at_start != reversed, line);
    }
  }

  [[nodiscard]] const Eigen::Vector3d& end_of(std::size_t i, bool start) const {
    return start ? segment(i).start : segment(i).end;
  }

  /// Ends found in two patches are treated as independent, although the patches may share images.
  void take_end(std::size_t from, bool at_start, bool its_start, UncertainLine& line) const {
    (at_start ? line.segment_in_world.start : line.segment_in_world.end) = end_of(from, its_start);
    const Eigen::Index at = at_start ? 0 : 3;
    const Eigen::Index its = its_start ? 0 : 3;
    line.covariance_m2.block<3, 3>(at, at) = lines_[from].line.covariance_m2.block<3, 3>(its, its);
    line.covariance_m2.block<3, 3>(at, 3 - at).setZero();
    line.covariance_m2.block<3, 3>(3 - at, at).setZero();
  }

  static constexpr double kMinCommonShare = 0.5;

  std::span<const FoundLine> lines_;
  const PatchGrid& grid_;
  const MergeOptions& options_;
  std::vector<std::vector<Duplicate>> twins_;  ///< of each line
  std::vector<GridCell> owners_;               ///< the square of each midpoint
};

/// Sort key by square, then number.
std::tuple<GridCell, std::size_t> place_of(const MergedLine& line) {
  return {line.cell, line.line};
}

}  // namespace

LineMerger::LineMerger(const PatchGrid& grid, const MergeOptions& options)
    : grid_(grid), options_(options) {}

std::vector<MergedLine> LineMerger::add(std::span<const FoundLine> strip) {
  std::int64_t last_column = std::numeric_limits<std::int64_t>::min();
  for (const FoundLine& found : strip) {
    last_column = std::max(last_column, found.cell.column);
    open_.push_back(found);
    numbers_.push_back(n_added_++);
  }
  if (strip.empty()) return {};
  const double east_m = grid_.square({last_column + 1, 0}).min().x() - options_.overlap_m;
  return merge_west_of(east_m);
}

std::vector<MergedLine> LineMerger::finish() {
  return merge_west_of(std::numeric_limits<double>::infinity());
}

std::vector<MergedLine> LineMerger::merge_west_of(double east_m) {
  const Merger merger(open_, grid_, options_);
  const std::vector<bool> is_open = merger.tied_to(transformed(open_, [&](const FoundLine& found) {
    return grid_.square(found.cell).max().x() + options_.overlap_m >= east_m;
  }));
  for (MergedLine& line : merger.merge(is_open)) {
    line.line = numbers_[line.line];
    waiting_.push_back(std::move(line));
  }
  std::ranges::sort(waiting_, {}, place_of);
  keep_open(is_open);
  return take_settled();
}

void LineMerger::keep_open(const std::vector<bool>& is_open) {
  std::size_t n_kept = 0;
  for (std::size_t i = 0; i < open_.size(); ++i) {
    if (!is_open[i]) continue;
    open_[n_kept] = open_[i];
    numbers_[n_kept++] = numbers_[i];
  }
  open_.resize(n_kept);
  numbers_.resize(n_kept);
}

std::vector<MergedLine> LineMerger::take_settled() {
  std::int64_t first_open = std::numeric_limits<std::int64_t>::max();
  for (const FoundLine& found : open_) first_open = std::min(first_open, found.cell.column);
  const auto rest = std::ranges::find_if(
      waiting_, [&](const MergedLine& line) { return line.cell.column >= first_open; });
  std::vector<MergedLine> settled(waiting_.begin(), rest);
  waiting_.erase(waiting_.begin(), rest);
  return settled;
}

std::size_t LineMerger::first_needed() const {
  std::size_t first = n_added_;
  for (const std::size_t number : numbers_) first = std::min(first, number);
  for (const MergedLine& line : waiting_) first = std::min(first, line.line);
  return first;
}

std::vector<MergedLine> merge_lines(std::span<const FoundLine> lines,
                                    const PatchGrid& grid,
                                    const MergeOptions& options) {
  LineMerger merger(grid, options);
  std::vector<MergedLine> merged = merger.add(lines);
  std::ranges::move(merger.finish(), std::back_inserter(merged));
  return merged;
}

}  // namespace ridgeline::reconstruct
