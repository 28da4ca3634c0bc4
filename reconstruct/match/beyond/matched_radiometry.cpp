// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/matched_radiometry.h"

#include "reconstruct/geometry/median.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/match/candidates.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

/// The colours of one surface in both images.
struct ColourPair {
  Colour left, right;
};

/// A line y = gain x + offset through weighted points.
struct LineFit {
  double w = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;

  void add(double weight, double at_x, double at_y) {
    w += weight;
    x += weight * at_x;
    y += weight * at_y;
    xx += weight * at_x * at_x;
    xy += weight * at_x * at_y;
  }
  [[nodiscard]] double variance() const { return xx / w - x * x / (w * w); }
  [[nodiscard]] double gain() const { return (xy / w - x * y / (w * w)) / variance(); }
  [[nodiscard]] double offset() const { return (y - gain() * x) / w; }
};

View longest_of(const View& view) {
  constexpr std::size_t kMaxSegments = 300;
  View longest = view;
  std::ranges::stable_sort(longest.segments, std::greater{},
                           [](const EdgeSegment& edge) { return length(edge.line.segment); });
  if (longest.segments.size() > kMaxSegments) longest.segments.resize(kMaxSegments);
  return longest;
}

void add_colours(const EdgeSegment& left,
                 const EdgeSegment& right,
                 const Candidate& candidate,
                 std::vector<ColourPair>& pairs) {
  constexpr double kSameTexture = 0.7;  // correlation that is hardly reached by chance
  const std::array<const Flank*, 2> own{&left.left, &left.right};
  const std::array<const Flank*, 2> counterpart =
      counterpart_flanks(right, candidate.overlap.reversed());
  for (const int side : {0, 1}) {
    const auto& seen = candidate.appearance.sides[side];
    if (seen && !candidate.appearance.is_past_wall[side] && seen->ncc >= kSameTexture) {
      pairs.push_back({own[side]->colour, counterpart[side]->colour});
    }
  }
}

double median_misclosure(std::span<const ColourPair> pairs, int band, double gain, double offset) {
  return upper_median(transformed(pairs, [&](const ColourPair& pair) {
    return std::abs(pair.left[band] - gain * pair.right[band] - offset);
  }));
}

/// Fits gain and offset by least squares, reweighted for Cauchy-distributed misclosures.
void refine_band(std::span<const ColourPair> pairs, int band, Radiometry& radiometry) {
  constexpr int kPasses = 10;
  constexpr double kMinScale = 0.002;  // in units of the range of grey values
  constexpr double kMinSpread = 0.05;  // minimum spread of the colours that determines a gain
  double gain = radiometry.gain[band];
  double offset = radiometry.offset[band];
  for (int pass = 0; pass < kPasses; ++pass) {
    const double scale = 1.5 * std::max(kMinScale, median_misclosure(pairs, band, gain, offset));
    LineFit fit;
    for (const ColourPair& pair : pairs) {
      const double ratio = (pair.left[band] - gain * pair.right[band] - offset) / scale;
      fit.add(1.0 / (1.0 + ratio * ratio), pair.right[band], pair.left[band]);
    }
    if (!(fit.variance() > kMinSpread * kMinSpread)) return;
    gain = fit.gain();
    offset = fit.offset();
  }
  radiometry.gain[band] = static_cast<float>(gain);
  radiometry.offset[band] = static_cast<float>(offset);
}

}  // namespace

Radiometry matched_radiometry(const SearchedPair& pair,
                              const Radiometry& first,
                              const CandidateOptions& options,
                              const CandidateAppearance& change_appearance) {
  constexpr std::size_t kMinPairs = 20;
  const View longest = longest_of(pair.left);
  const Candidates candidates =
      match_candidates({longest, pair.right, pair.search}, first, options, change_appearance);
  std::vector<ColourPair> pairs;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].empty()) continue;
    const Candidate& best = candidates[i].front();
    add_colours(longest.segments[i], pair.right.segments[best.right], best, pairs);
  }
  if (pairs.size() < kMinPairs) return first;
  Radiometry refined = first;
  for (int band = 0; band < pair.left.image.channels(); ++band) refine_band(pairs, band, refined);
  return refined;
}

}  // namespace ridgeline::reconstruct
