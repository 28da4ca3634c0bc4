// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/appearance/image_sampler.h"
#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/epipolar_overlap.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// Maps colours of the right image to those of the left one, per band: gain x + offset.
struct Radiometry {
  Colour gain{1.0F, 1.0F, 1.0F, 1.0F};
  Colour offset{};

  [[nodiscard]] Colour left_from_right(const Colour& right) const {
    Colour left{};
    for (int band = 0; band < kMaxBands; ++band)
      left[band] = gain[band] * right[band] + offset[band];
    return left;
  }
};

/// A pair of images with the data needed to compare them.
struct ImagePair {
  ImageSampler left, right;
  Radiometry radiometry;
};

/// Similarity of the strips along one side of a line in the two images.
struct SideAppearance {
  double ncc = 0.0;  ///< -1..1, over all bands, damped if there is little texture
  /// Difference of the mean colours, root mean square over the bands.
  double colour_difference = 0.0;

  /// Agreement of the mean colours: 1 for equal colours, 1/e for a difference of a twentieth of the
  /// range of grey values.
  [[nodiscard]] double colour_agreement() const;
  /// Combined agreement of texture and colour, 0..2.
  [[nodiscard]] double agreement() const { return std::max(0.0, ncc) + colour_agreement(); }
};

/// Sampling density and extent of the strips.
struct StripGrid {
  /// Distance of the first sample from the line, clear of the blurred edge.
  double first_offset_px = 1.5;
  double offset_step_px = 1.0;
  int n_offsets = 8;
  int most_along = 20;
  int n_slopes = 3;  ///< 1: level sides only
  bool with_profile = true;
};

/// The points on the line at which the rows of a strip start in both images, in file pixels, and
/// the vectors of one step to the side: a pixel of the reduced image in which the softer of the two
/// edges was found.
struct StripFrame {
  std::vector<Eigen::Vector2d> on_left, on_right;
  Eigen::Vector2d side_in_left, side_in_right;
  double scale_px = 1.0;  ///< of the softer edge: size of a grid step in image pixels
};

/// A left and a right segment that may show the same edge, and their overlap.
struct EdgePair {
  const EdgeSegment& left;
  const EdgeSegment& right;
  const EpipolarOverlap& overlap;
};

/// The rows of the strips along the epipolar overlap of two segments, one every 1.5 steps, but at
/// least 4 and at most `most_along` rows. The caller sets `side_in_right`.
StripFrame strip_frame(const EdgePair& edges, int most_along);

/// Colours next to a line, row by row along it. Samples outside the image have no colour.
struct Strip {
  std::vector<Colour> colours;
  std::vector<char> is_inside;
};

/// Samples the colours of a strip.
/// @param side  vector of one pixel away from the line
Strip sample_strip(const ImageSampler& image,
                   std::span<const Eigen::Vector2d> on_line,
                   const Eigen::Vector2d& side,
                   const StripGrid& grid);

/// Mean colours of a strip at each offset from the line; empty if a sample lies outside the image.
std::vector<Colour> mean_profile(const Strip& strip, const StripGrid& grid);

/// Compares strips of the same grid. std::nullopt if more than half of the samples lie outside one
/// of the images.
std::optional<SideAppearance> compare(const Strip& left,
                                      const Strip& right,
                                      const Radiometry& radiometry,
                                      int n_bands);

/// Sums for the normalised cross correlation of one band.
struct BandSums {
  double a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
  void add(double x, double y) {
    a += x;
    b += y;
    aa += x * x;
    bb += y * y;
    ab += x * y;
  }
};
/// Normalised cross correlation over all bands. The noise variance per band, `noise_variance`,
/// damps it if there is little texture. The result is 0 if a side has no variance at all.
double correlation(std::span<const BandSums> bands, int n_samples, double noise_variance = 0.0);
/// Normalised cross correlation over all bands of two profiles of the same length.
double correlation(std::span<const Colour> a,
                   std::span<const Colour> b,
                   double noise_variance = 0.0);
/// The appearance of a side with n > 0 samples.
SideAppearance side_appearance(const std::array<BandSums, kMaxBands>& sums,
                               int n_bands,
                               int n_samples);

}  // namespace ridgeline::reconstruct
