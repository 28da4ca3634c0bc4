// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/candidates.h"

#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/interruption.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

/// The height range is widened by this, because noise can move a height beyond its limits.
constexpr double kHeightTolerance_px = 2.0;
/// Largest distance of near-aligned segments from each other's epipolar band; our own value.
constexpr double kEpipolarTolerance_px = 2.0;
constexpr double kParallaxStep_px = 1.0;  // step of the search along near-aligned lines
/// The grid for choosing among many parallaxes, coarser than the one of the final comparison.
constexpr StripGrid kCoarseGrid{1.5, 2.0, 3, 16, 1, false};

struct CandidateSearch {
  const SearchedPair& pair;
  ImagePair images;
  const CandidateOptions& options;
  const CandidateAppearance& change_appearance;
  int max_candidates;
  BoxIndex2 right_index;
};

/// The box around the possible positions of both ends of a left segment in the right image.
Eigen::AlignedBox2d band_box(const SearchedSegment& left,
                             const std::array<double, 2>& heights_m,
                             double margin_px) {
  Eigen::AlignedBox2d box;
  for (const double z : heights_m) box.extend(left.start.at(z)).extend(left.end.at(z));
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(margin_px);
  return Eigen::AlignedBox2d(box.min() - margin, box.max() + margin);
}

double sum_of_ncc(const EdgeAppearance& appearance) {
  double sum = 0.0;
  for (const auto& side : appearance.sides) sum += side ? side->ncc : 0.0;
  return sum;
}

/// The overlap at which two near-aligned segments are most similar.
std::optional<EpipolarOverlap> best_aligned_overlap(const CandidateSearch& search,
                                                    const SearchedSegment& searched,
                                                    const LocalTransfer& transfer,
                                                    const EdgeSegment& left,
                                                    const EdgeSegment& right) {
  if (acute_angle_rad(left.line.segment, right.line.segment) >
      3.0 * kMinEpipolarAngle_deg * kRadPerDeg) {
    return std::nullopt;
  }
  std::optional<EpipolarOverlap> best;
  double best_ncc = 0.0;
  for (const EpipolarOverlap& overlap :
       aligned_overlaps(searched, right.line.segment, search.pair.search.height_range_m,
                        kEpipolarTolerance_px, kParallaxStep_px)) {
    const double ncc =
        sum_of_ncc(edge_appearance(search.images, {left, right, overlap}, transfer, kCoarseGrid));
    if (best && ncc <= best_ncc) continue;
    best = overlap;
    best_ncc = ncc;
  }
  return best;
}

bool admissible(const EpipolarOverlap& overlap,
                const SearchedSegment& searched,
                double gsd_m,
                const std::array<double, 2>& heights_m,
                const CandidateOptions& options) {
  const double tolerance_m = kHeightTolerance_px / searched.px_per_m;
  const double run_m = gsd_m * overlap.share_of_left() * length(searched.segment);
  const double rise_m = std::abs(overlap.height_m[1] - overlap.height_m[0]);
  if (rise_m > std::tan(options.max_slope_deg * kRadPerDeg) * run_m + tolerance_m) return false;
  for (const double z : overlap.height_m) {
    if (!(z >= heights_m[0] - tolerance_m && z <= heights_m[1] + tolerance_m)) return false;
  }
  return std::max(overlap.share_of_left(), overlap.share_of_right()) >= kMinEpipolarOverlap;
}

std::optional<Candidate> candidate(const CandidateSearch& search,
                                   const SearchedSegment& searched,
                                   const LocalTransfer& transfer,
                                   const EdgeSegment& left,
                                   int right_id) {
  const EdgeSegment& right = search.pair.right.segments[right_id];
  const CandidateOptions& options = search.options;
  const Segment2& b = right.line.segment;
  if (transfer.turn_rad(left.line.segment, b) > options.max_turn_deg * kRadPerDeg) {
    return std::nullopt;
  }
  const bool aligned = is_near_aligned(searched, b, kMinEpipolarAngle_deg * kRadPerDeg);
  const std::optional<EpipolarOverlap> overlap =
      aligned ? best_aligned_overlap(search, searched, transfer, left, right)
              : epipolar_overlap(searched, b);
  if (!overlap ||
      !admissible(*overlap, searched, transfer.gsd_m, search.pair.search.height_range_m, options)) {
    return std::nullopt;
  }
  const EdgePair edges{left, right, *overlap};
  EdgeAppearance appearance = edge_appearance(search.images, edges, transfer);
  if (search.change_appearance && !aligned) {
    const double lowest_m = std::min(overlap->height_m[0], overlap->height_m[1]);
    search.change_appearance(search.images, edges, transfer,
                             lowest_m - search.pair.search.height_range_m[0], appearance);
  }
  Candidate found;
  found.appearance = appearance;
  found.right = right_id;
  found.overlap = *overlap;
  found.measures = line_measures(edges, appearance, search.images.radiometry);
  found.similarity = line_similarity(found.measures);
  return found;
}

std::vector<Candidate> candidates_of(const CandidateSearch& search, const EdgeSegment& left) {
  std::vector<Candidate> candidates;
  const std::optional<SearchedSegment> searched =
      searched_segment(search.pair.search, left.line.segment);
  if (!searched) return candidates;
  const auto& heights_m = search.pair.search.height_range_m;
  const LocalTransfer transfer = local_transfer(search.pair.search, midpoint(left.line.segment));
  const Eigen::AlignedBox2d box = band_box(*searched, heights_m, kEpipolarTolerance_px);
  for (const std::size_t id : search.right_index.near(box, 0.0)) {
    if (auto found = candidate(search, *searched, transfer, left, static_cast<int>(id))) {
      candidates.push_back(*found);
    }
  }
  std::ranges::stable_sort(candidates, std::greater{}, &Candidate::similarity);
  if (static_cast<int>(candidates.size()) > search.max_candidates)
    candidates.resize(static_cast<std::size_t>(search.max_candidates));
  return candidates;
}

}  // namespace

Candidates match_candidates(const SearchedPair& pair,
                            const Radiometry& radiometry,
                            const CandidateOptions& options,
                            const CandidateAppearance& change_appearance,
                            int max_candidates) {
  validate(options);
  const CandidateSearch all{
      pair,           {ImageSampler(pair.left.image), ImageSampler(pair.right.image), radiometry},
      options,        change_appearance,
      max_candidates, BoxIndex2(ideal_segments(pair.right))};
  const std::vector<EdgeSegment>& left = pair.left.segments;
  Candidates candidates(left.size());
  tbb::parallel_for(std::size_t{0}, left.size(), [&](std::size_t i) {
    Interruption::check();
    candidates[i] = candidates_of(all, left[i]);
  });
  return candidates;
}

}  // namespace ridgeline::reconstruct
