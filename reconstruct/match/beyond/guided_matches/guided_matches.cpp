// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/guided_matches/guided_matches.h"

#include "reconstruct/appearance/edge_appearance.h"
#include "reconstruct/extract/ok2011/edge_segments.h"
#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/interruption.h"
#include "reconstruct/match/beyond/guided_matches/predicted_counterpart.h"
#include "reconstruct/match/beyond/guided_matches/step_along.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

// Minimum length of a guide, because shorter ones are often texture.
constexpr double kMinGuideLength_px = 15.0;
/// Minimum similarity of the appearance of a match (calibration.md).
constexpr double kMinGuidedSimilarity = 0.8;

/// A step that may be the counterpart of a segment of the other view.
struct FoundStep {
  std::size_t guide;  ///< index of that segment
  EdgeSegment counterpart;
  double similarity = 0.0;
};

/// Whether segments run along most of a segment.
bool is_covered(const Segment2& segment, const BoxIndex2& index, std::span<const Segment2> by) {
  // A segment farther away is another edge, or a blur of two edges.
  constexpr double kBeside_px = 0.6;
  constexpr double kMaxSlope = 0.15;
  constexpr double kMaxCoveredShare = 0.5;  // share of the segment
  const Eigen::Vector2d u = along(segment);
  const Eigen::Vector2d n = normal_of(u);
  double covered_px = 0.0;
  for (const std::size_t id : index.near(segment, kBeside_px)) {
    const Segment2& other = by[id];
    if (std::abs(along(other).dot(n)) > kMaxSlope) continue;
    const double start = u.dot(other.start - segment.start);
    const double end = u.dot(other.end - segment.start);
    const double low = std::max(0.0, std::min(start, end));
    const double high = std::min(length(segment), std::max(start, end));
    if (high <= low) continue;
    const auto beside_px = [&](double t) {
      return std::abs(n.dot(point_at(other, (t - start) / (end - start)) - segment.start));
    };
    if (std::max(beside_px(low), beside_px(high)) <= kBeside_px) covered_px += high - low;
  }
  return covered_px > kMaxCoveredShare * length(segment);
}

/// For each segment of a view, whether it has a counterpart.
std::vector<char> has_counterpart(const StereoPair& pair,
                                  std::span<const Correspondence> known,
                                  std::size_t view) {
  std::vector<char> has(pair.views[view]->segments.size(), 0);
  for (const Correspondence& m : known)
    has.at(static_cast<std::size_t>(view == 0 ? m.base : m.other)) = 1;
  return has;
}

/// The steps predicted from the unmatched segments of view `from`, in their order.
std::vector<FoundStep> steps_of(const StereoPair& pair,
                                const Surface& surface,
                                std::span<const Correspondence> known,
                                std::size_t from,
                                const ExtractOptions& options) {
  const std::vector<EdgeSegment>& guides = pair.views[from]->segments;
  const View& there = *pair.views[1 - from];
  const PredictedCounterpart prediction(surface, from);
  const ImageSampler image(there.image);
  const std::vector<char> is_matched = has_counterpart(pair, known, from);
  std::vector<std::optional<EdgeTrace>> found(guides.size());
  tbb::parallel_for(std::size_t{0}, guides.size(), [&](std::size_t i) {
    Interruption::check();
    const Segment2& guide = guides[i].line.segment;
    if (is_matched[i] != 0 || length(guide) < kMinGuideLength_px) return;
    if (const auto counterpart = prediction.of(guide)) {
      const Segment2 in_image{image_from_ideal(there.ideal_from_image, counterpart->start),
                              image_from_ideal(there.ideal_from_image, counterpart->end)};
      found[i] = step_along(image, in_image);
    }
  });
  const std::vector<Segment2> segments = ideal_segments(there);
  const BoxIndex2 index(segments);
  std::vector<FoundStep> steps;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) continue;
    for (EdgeSegment& counterpart :
         edge_segments({*found[i]}, there.image, there.ideal_from_image, options)) {
      if (is_covered(counterpart.line.segment, index, segments)) continue;
      counterpart.guided = true;
      steps.push_back({i, std::move(counterpart)});
    }
  }
  return steps;
}

View without_segments(const View& view) {
  return {view.id, view.image_from_local, view.image, view.ideal_from_image};
}

/// Sets the similarity of steps to their guides from their appearance.
void compare(const StereoPair& pair,
             std::size_t from,
             const GuideOptions& options,
             const CandidateAppearance& change_appearance,
             std::vector<FoundStep>& steps) {
  constexpr double kUndecided = 0.5;
  std::array<View, 2> guided{without_segments(*pair.views[0]), without_segments(*pair.views[1])};
  for (const FoundStep& step : steps) {
    guided[from].segments.push_back(pair.views[from]->segments[step.guide]);
    guided[1 - from].segments.push_back(step.counterpart);
  }
  const Radiometry radiometry =
      relative_radiometry(pair.views[0]->segments, pair.views[1]->segments);
  const Candidates candidates =
      match_candidates(searched({{guided.data(), guided.data() + 1}, pair.height_range_in_local_m}),
                       radiometry, options.candidates, change_appearance);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    for (const Candidate& candidate : candidates[k]) {
      if (candidate.right != static_cast<int>(k)) continue;
      LineMeasures measures = candidate.measures;
      measures.values[LineMeasures::kEnds] = kUndecided;
      steps[k].similarity = line_similarity(measures);
    }
  }
}

}  // namespace

GuidedMatches guided_matches(const StereoPair& pair,
                             const Surface& surface,
                             std::span<const Correspondence> known,
                             const GuideOptions& options,
                             const CandidateAppearance& change_appearance) {
  GuidedMatches result;
  for (const std::size_t from : {0U, 1U}) {
    std::vector<FoundStep> steps = steps_of(pair, surface, known, from, options.edges);
    compare(pair, from, options, change_appearance, steps);
    std::ranges::stable_sort(steps, std::greater{}, &FoundStep::similarity);
    std::vector<char> is_matched(pair.views[from]->segments.size(), 0);
    std::vector<Segment2> taken;
    std::vector<EdgeSegment>& counterparts = result.counterparts[1 - from];
    for (FoundStep& step : steps) {
      if (step.similarity < kMinGuidedSimilarity) break;
      if (is_matched[step.guide] != 0 ||
          is_covered(step.counterpart.line.segment, BoxIndex2(taken), taken)) {
        continue;
      }
      is_matched[step.guide] = 1;
      taken.push_back(step.counterpart.line.segment);
      const auto guide = static_cast<int>(step.guide);
      const auto counterpart =
          static_cast<int>(pair.views[1 - from]->segments.size() + counterparts.size());
      result.matches.push_back(from == 0 ? Correspondence{guide, counterpart, step.similarity}
                                         : Correspondence{counterpart, guide, step.similarity});
      counterparts.push_back(std::move(step.counterpart));
    }
  }
  std::ranges::sort(result.matches, {}, &Correspondence::segments);
  return result;
}

}  // namespace ridgeline::reconstruct
