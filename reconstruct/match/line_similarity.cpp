// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/line_similarity.h"

#include "reconstruct/match/constraints.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kColourScale = 0.05;  // of the range of grey values

}  // namespace

LineMeasures line_measures(const EdgeSegment& left,
                           const EdgeSegment& right,
                           const EpipolarOverlap& overlap,
                           const EdgeLook& look,
                           const Radiometry& radiometry,
                           double gsd_m) {
  constexpr double kUndecided = 0.5;
  LineMeasures m;
  std::array<double, 2> ncc{};
  std::array<double, 2> colour{};
  for (const int side : {0, 1}) {
    const auto& seen = look.sides[side];
    ncc[side] = seen ? std::max(0.0, seen->ncc) : kUndecided;
    colour[side] = seen ? std::exp(-seen->colour_difference / kColourScale) : kUndecided;
  }
  m.values[LineMeasures::kBetterSide] = std::max(ncc[0], ncc[1]);
  m.values[LineMeasures::kOtherSide] = std::min(ncc[0], ncc[1]);
  m.values[LineMeasures::kBetterColour] = std::max(colour[0], colour[1]);
  m.values[LineMeasures::kOtherColour] = std::min(colour[0], colour[1]);
  m.values[LineMeasures::kContrast] =
      contrast_similarity(left, right, overlap.reversed(), radiometry).value_or(kUndecided);
  m.values[LineMeasures::kOverlap] = std::max(overlap.share_of_left(), overlap.share_of_right());
  m.values[LineMeasures::kExtent] = std::min(overlap.share_of_left(), overlap.share_of_right());
  const double rise_m = std::abs(overlap.height_m[1] - overlap.height_m[0]);
  const double run_m = gsd_m * overlap.share_of_left() * length(left.line.segment);
  m.values[LineMeasures::kLevel] = run_m > 0.0 ? run_m / std::hypot(run_m, rise_m) : 0.0;
  return m;
}

double line_similarity(const LineMeasures& measures) {
  static constexpr std::array<double, LineMeasures::kCount> kWeights = {1.27, 4.01, 4.64, 1.61,
                                                                        0.99, 7.18, 3.71, 0.97};
  constexpr double kBias = -16.8;
  double sum = kBias;
  for (int k = 0; k < LineMeasures::kCount; ++k) sum += kWeights[k] * measures.values[k];
  return 1.0 / (1.0 + std::exp(-sum));
}

}  // namespace ridgeline::reconstruct
