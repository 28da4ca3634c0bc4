// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/appearance/line_similarity.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kColourScale = 0.08;  // in units of the range of grey values
constexpr double kEndScale_px = 3.0;   // uncertainty of end points along a line

/// Mean over the two ends of exp(-gap / scale). The gap is the length by which one segment extends
/// beyond the other.
double ends_agreement(const EdgePair& edges) {
  const auto& [left, right, overlap] = edges;
  const double left_px = length(left.line.segment);
  const double right_px = length(right.line.segment);
  const auto gap_px = [&](double of_left, double of_right) {
    return std::max(of_left * left_px, of_right * right_px);
  };
  const auto from_start = [](double t, bool reversed) { return reversed ? 1.0 - t : t; };
  const bool reversed = overlap.reversed();
  const double at_start = gap_px(overlap.on_left[0], from_start(overlap.on_right[0], reversed));
  const double at_end =
      gap_px(1.0 - overlap.on_left[1], 1.0 - from_start(overlap.on_right[1], reversed));
  return 0.5 * (std::exp(-at_start / kEndScale_px) + std::exp(-at_end / kEndScale_px));
}

Colour difference(const Colour& a, const Colour& b) {
  Colour d{};
  for (int band = 0; band < kMaxBands; ++band) d[band] = a[band] - b[band];
  return d;
}

double norm(const Colour& c) {
  double squared = 0.0;
  for (const float value : c) squared += static_cast<double>(value) * value;
  return std::sqrt(squared);
}

/// Colours of a right segment's flanks, ordered as left and right of the left segment.
struct Sides {
  Colour left, right;
};
Sides mapped_sides(const EdgePair& edges, const Radiometry& radiometry) {
  const auto [on_left, on_right] = counterpart_flanks(edges.right, edges.overlap.reversed());
  return {radiometry.left_from_right(on_left->colour),
          radiometry.left_from_right(on_right->colour)};
}

}  // namespace

std::optional<double> colour_similarity(const EdgePair& edges, const Radiometry& radiometry) {
  const Sides counterpart = mapped_sides(edges, radiometry);
  const double smallest = std::min(norm(difference(edges.left.left.colour, counterpart.left)),
                                   norm(difference(edges.left.right.colour, counterpart.right)));
  return std::exp(-0.5 * (smallest / kColourScale) * (smallest / kColourScale));
}

std::optional<double> contrast_similarity(const EdgePair& edges, const Radiometry& radiometry) {
  const Sides counterpart = mapped_sides(edges, radiometry);
  const Colour step = difference(edges.left.right.colour, edges.left.left.colour);
  const Colour counterpart_step = difference(counterpart.right, counterpart.left);
  const double both = norm(step) + norm(counterpart_step);
  if (!(both > 0.0)) return std::nullopt;
  return 1.0 - norm(difference(step, counterpart_step)) / both;
}

LineMeasures line_measures(const EdgePair& edges,
                           const EdgeAppearance& appearance,
                           const Radiometry& radiometry) {
  constexpr double kUndecided = 0.5;
  LineMeasures m;
  std::array<double, 2> ncc{};
  std::array<double, 2> colour{};
  for (const int side : {0, 1}) {
    const auto& seen = appearance.sides[side];
    ncc[side] = seen ? std::max(0.0, seen->ncc) : kUndecided;
    colour[side] = seen ? seen->colour_agreement() : kUndecided;
  }
  m.values[LineMeasures::kBetterSide] = std::max(ncc[0], ncc[1]);
  m.values[LineMeasures::kOtherSide] = std::min(ncc[0], ncc[1]);
  m.values[LineMeasures::kBetterColour] = std::max(colour[0], colour[1]);
  m.values[LineMeasures::kOtherColour] = std::min(colour[0], colour[1]);
  m.values[LineMeasures::kContrast] = contrast_similarity(edges, radiometry).value_or(kUndecided);
  m.values[LineMeasures::kProfile] = std::max(0.0, appearance.profile_ncc.value_or(kUndecided));
  m.values[LineMeasures::kOverlap] =
      std::max(edges.overlap.share_of_left(), edges.overlap.share_of_right());
  m.values[LineMeasures::kEnds] = ends_agreement(edges);
  return m;
}

double line_similarity(const LineMeasures& measures) {
  static constexpr std::array<double, LineMeasures::kCount> kWeights = {0.65, 3.50, 1.83, 3.44,
                                                                        1.38, 0.34, 2.51, 5.05};
  constexpr double kBias = -9.65;
  double sum = kBias;
  for (int k = 0; k < LineMeasures::kCount; ++k) sum += kWeights[k] * measures.values[k];
  return 1.0 / (1.0 + std::exp(-sum));
}

}  // namespace ridgeline::reconstruct
