// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/segment.h"
#include "reconstruct/scene/patch_grid.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// A line with the covariance of its ends, (start, end), m^2.
struct UncertainLine {
  Segment3 segment_in_world;
  Eigen::Matrix<double, 6, 6> covariance_m2;
};

/// A line as the patch of one square found it.
struct FoundLine {
  UncertainLine line;
  GridCell cell;
};

struct MergeOptions {
  double overlap_m = 0.0;  ///< by which a patch reaches beyond its square on all sides
  /// Two lines are one if chance makes them differ more in fewer cases than this share.
  double significance = 1e-3;
};

/// A line of the block.
struct MergedLine {
  std::size_t line =
      0;  ///< number of the found line that it is, from 0 in the order in which lines were given
  GridCell cell;           ///< of that line: its own square
  UncertainLine geometry;  ///< of that line, or longer if the line leaves its patch
};

/// Makes one set of lines of those that overlapping patches found, strip by strip, so that it holds
/// the lines of a strip and of its neighbours only. A strip is one or more columns of squares.
///
/// Two lines of different patches are duplicates if, within the place that both patches cover, they
/// run beside each other over half of the shorter one at least, and both ends of the shorter one
/// lie on the longer one by the covariances (chi-square of four degrees of freedom). A line belongs
/// to the square of its midpoint. It counts if the patch of that square found it, or found a
/// duplicate of it: so the noise of a midpoint beside a seam neither loses nor doubles a line. Of
/// duplicates the longest one that its own square has stays. A line that ends beyond the square of
/// its patch, where another patch knows better, is prolonged by its duplicates, one after another.
/// So a line that no patch shows whole is whole. A prolonged line has the covariances of the ends
/// that it takes.
///
/// Duplicates, and duplicates of duplicates, decide among themselves. They are merged as soon as no
/// later strip can have another duplicate.
class LineMerger {
 public:
  LineMerger(const PatchGrid& grid, const MergeOptions& options);

  /// Adds the lines of a strip that lies east of all before, in the order of their squares, each
  /// set in the order of its file. Returns the merged lines that no later strip changes, in the
  /// order of squares and of numbers, each once over all calls.
  std::vector<MergedLine> add(std::span<const FoundLine> strip);
  /// The rest, after the last strip.
  std::vector<MergedLine> finish();

  /// Lines with lower numbers are in no result that is still to come.
  [[nodiscard]] std::size_t first_needed() const;

 private:
  /// Merges the lines without a duplicate in what may reach beyond `east_m`.
  std::vector<MergedLine> merge_west_of(double east_m);
  void keep_open(const std::vector<bool>& is_open);
  std::vector<MergedLine> take_settled();

  PatchGrid grid_;
  MergeOptions options_;
  std::size_t n_added_ = 0;
  std::vector<FoundLine> open_;  ///< may have duplicates in later strips, or are tied to such lines
  std::vector<std::size_t> numbers_;  ///< of the open lines
  std::vector<MergedLine> waiting_;   ///< merged, while lines of squares before them are open
};

/// All lines at once, in any order of their squares, on which the result does not depend.
std::vector<MergedLine> merge_lines(std::span<const FoundLine> lines,
                                    const PatchGrid& grid,
                                    const MergeOptions& options);

}  // namespace ridgeline::reconstruct
