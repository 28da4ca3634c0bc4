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

/// A line as found in the patch of one square.
struct FoundLine {
  UncertainLine line;
  GridCell cell;
};

struct MergeOptions {
  double overlap_m = 0.0;  ///< distance by which a patch extends beyond its square on all sides
  /// Two lines are considered different if chance would make them differ more in fewer cases than
  /// this share.
  double significance = 1e-3;
};

/// A line of the block.
struct MergedLine {
  std::size_t line = 0;    ///< number of the found line, from 0 in input order
  GridCell cell;           ///< of that line: its own square
  UncertainLine geometry;  ///< of that line, or longer if the line leaves its square
};

/// Merges the lines found in overlapping patches into one set, strip by strip, so that it only
/// holds the lines of a strip and its neighbours at a time. A strip is one or more columns of
/// squares.
///
/// Two lines of different patches are duplicates if, within the area that both patches cover, they
/// run alongside each other over at least half of the shorter one, and both ends of the shorter one
/// lie on the longer one according to the covariances (chi-square with four degrees of freedom). A
/// line belongs to the square of its midpoint. It is kept if the patch of that square found it or a
/// duplicate of it, so that the noise of a midpoint near a seam neither loses nor doubles a line.
/// Of several duplicates, the longest one found by the patch of its own square remains. A line that
/// ends beyond the square of its patch, where another patch is more reliable, is extended by its
/// duplicates, one after another. A line that no single patch shows completely is thus complete. An
/// extended line has the covariances of the ends that it takes over.
///
/// Duplicates, and duplicates of duplicates, are merged together, as soon as no later strip can
/// have another duplicate of them.
class LineMerger {
 public:
  LineMerger(const PatchGrid& grid, const MergeOptions& options);

  /// Adds the lines of a strip that lies east of all previous ones, in the order of their squares
  /// and, within a square, of its file. Returns the merged lines that no later strip can change, in
  /// the order of squares and numbers. Each line is returned once over all calls.
  std::vector<MergedLine> add(std::span<const FoundLine> strip);
  /// The remaining lines, after the last strip.
  std::vector<MergedLine> finish();

  /// Lines with lower numbers appear in no later result.
  [[nodiscard]] std::size_t first_needed() const;

 private:
  /// Merges the lines that are not tied by duplicates to a line whose patch reaches `east_m`.
  std::vector<MergedLine> merge_west_of(double east_m);
  void keep_open(const std::vector<bool>& is_open);
  std::vector<MergedLine> take_settled();

  PatchGrid grid_;
  MergeOptions options_;
  std::size_t n_added_ = 0;
  std::vector<FoundLine> open_;  ///< may have duplicates in later strips, or are tied to such lines
  std::vector<std::size_t> numbers_;  ///< of the open lines
  std::vector<MergedLine> waiting_;   ///< merged, but lines of earlier squares are still open
};

/// Merges all lines at once. The result does not depend on the order of their squares.
std::vector<MergedLine> merge_lines(std::span<const FoundLine> lines,
                                    const PatchGrid& grid,
                                    const MergeOptions& options);

}  // namespace ridgeline::reconstruct
