// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/depth_consensus/flank_strips.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Normalised cross correlation of the strips beside a match, for any assignment of places in the
/// right strip to samples of the left one.
///
/// Each row counts less its mean along the line, so that the profile across the edge, which is the
/// same at every depth, does not. All products that an assignment may need are summed over the rows
/// once, by sample and place; an assignment then costs one look-up per sample.
class StripCorrelation {
 public:
  /// @param columns     samples of the left strip that take part, ascending
  /// @param swap_sides  the axes run opposite ways: one side is the other one of the right strip
  /// @param parallax    px per px of height, about the ratio of base and height; not negative
  StripCorrelation(const FlankStrips& strips,
                   std::vector<int> columns,
                   bool swap_sides,
                   double parallax);

  [[nodiscard]] std::size_t n_samples() const { return columns_.size(); }

  /// -1 to 1, of the samples whose place is inside of the right image; 0 for less than half of them.
  /// @param places  in samples of the right strip, by sample; monotonic
  [[nodiscard]] double level(std::size_t side, std::span<const double> places) const {
    return at_slope(side, kLevel, places);
  }
  /// Slopes of the side that are tried: from falling away from the line as a roof to rising so.
  static constexpr std::size_t kSlopes = 3;
  /// The same for a side of one of these slopes.
  [[nodiscard]] double at_slope(std::size_t side,
                                std::size_t slope,
                                std::span<const double> places) const;
  /// For the best of the slopes.
  [[nodiscard]] double best(std::size_t side, std::span<const double> places) const;

 private:
  static constexpr std::size_t kLevel = 1;  ///< of them

  /// Running sums along a row.
  struct RowSums {
    std::vector<double> values, squares;
  };
  struct Moments {
    double mean, variance;
  };
  struct Side {
    std::array<std::vector<float>, kSlopes> products;  ///< [sample][place]
    std::vector<RowSums> left, right;                  ///< by row and band
    double left_variance = 0.0;                        ///< of all samples, sum over the rows
    int first_inside = 0, end_inside = 0;              ///< places in the right image
  };

  /// The samples whose places are in the right image, and what their correlation is referred to.
  struct Cover {
    std::size_t first, end;
    double product_of_means, norm;
  };
  static RowSums running_sums(const std::vector<float>& row);
  static Moments moments(const RowSums& row, std::size_t from, std::size_t to);
  static bool is_inside(const Side& side, double place) {
    return place >= side.first_inside && place < side.end_inside - 1.0;
  }
  [[nodiscard]] std::optional<Cover> cover(const Side& side, std::span<const double> places) const;
  [[nodiscard]] double correlation(const Side& side,
                                   std::size_t slope,
                                   std::span<const double> places,
                                   const Cover& cover) const;
  [[nodiscard]] double shift(std::size_t slope, int row) const;
  [[nodiscard]] Side side_of(const FlankStrips& strips,
                             std::size_t side,
                             std::size_t right_side) const;

  int n_right_ = 0;
  double parallax_ = 0.0;
  double noise_ = 0.0;  ///< variance of a sample, sum over the rows
  std::vector<int> columns_;
  std::array<Side, 2> sides_;
};

}  // namespace ridgeline::reconstruct
