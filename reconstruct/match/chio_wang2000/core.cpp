// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/core.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/match/candidates.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ridgeline::reconstruct {
namespace {

// Chio and Wang 2000, section 4. Rates of height change are in m/m.
constexpr double kMaxRate = 1.0;                      // of the mean
constexpr double kMaxRateSigma = 3.0;                 // of the pieces
constexpr double kMaxFlankDifference = 20.0 / 255.0;  // share of the range of grey values
constexpr int kMinLinkPieces = 5;
constexpr double kMaxLinkRateDifference = 0.2;

constexpr double kSigmas = 3.0;  // multiple of the sigma of rates that is allowed as noise
constexpr int kMaxCandidatesOfAnyAppearance = 100;  // if the appearance does not decide

/// One left segment on its way through the screening.
struct Screened {
  const EdgeSegment& left;
  LocalTransfer transfer;
  std::vector<SearchedPoint> points;
};

struct CoreContext {
  const SearchedPair& pair;
  const Radiometry& radiometry;
  const ChioOptions& options;
  const ChioExtensions& beyond;
};

/// Allowance for noise in the mean rate of a chain and in the standard deviation of its rates.
struct RateNoise {
  double mean = 0.0, sigma = 0.0;
};

RateNoise rate_noise(const ChainSummary& chain, double gsd_m, const ChioExtensions& beyond) {
  if (!beyond.noise) return {};
  const double edge_sigma_px = beyond.noise->edge_sigma_px;
  return {kSigmas * expected_mean_rate_sigma(chain, gsd_m, edge_sigma_px),
          kSigmas * expected_rate_sigma(chain, gsd_m, edge_sigma_px)};
}

/// The largest difference of azimuths. A slope turns a line between the views; the paper's limit
/// does not allow for that, but NoiseAllowance does.
double azimuth_limit_rad(const LocalTransfer& transfer, const CoreContext& context) {
  const double turn_rad =
      context.beyond.noise ? std::atan(kMaxRate * transfer.base_to_height()) : 0.0;
  return context.options.max_azimuth_deg * kRadPerDeg + turn_rad;
}

double mean_of(const Colour& colour, int n_bands) {
  double sum = 0.0;
  for (int band = 0; band < n_bands; ++band) sum += static_cast<double>(colour[band]);
  return sum / n_bands;
}

/// Grey-value difference of the flank that agrees better, because an eave hides what is beside it
/// in one of the views.
double flank_difference(const CoreContext& context, const EdgePair& edges) {
  const int n_bands = context.pair.left.image.channels();
  const auto grey = [&](const Flank& flank) {
    return mean_of(context.radiometry.left_from_right(flank.colour), n_bands);
  };
  const auto [counterpart_of_left, counterpart_of_right] =
      counterpart_flanks(edges.right, edges.overlap.reversed());
  return std::min(
      std::abs(mean_of(edges.left.left.colour, n_bands) - grey(*counterpart_of_left)),
      std::abs(mean_of(edges.left.right.colour, n_bands) - grey(*counterpart_of_right)));
}

ChioOutcome screening(const CoreContext& context,
                      const Screened& screened,
                      const Candidate& candidate,
                      const ChainSummary& chain) {
  const ChioOptions& options = context.options;
  const RateNoise noise = rate_noise(chain, screened.transfer.gsd_m, context.beyond);
  const EdgeSegment& right = context.pair.right.segments[candidate.right];
  if (chain.n_reliable < options.min_pieces) return ChioOutcome::kFewPieces;
  if (screened.transfer.turn_rad(screened.left.line.segment, right.line.segment) >
      azimuth_limit_rad(screened.transfer, context)) {
    return ChioOutcome::kAzimuth;
  }
  if (flank_difference(context, {screened.left, right, candidate.overlap}) > kMaxFlankDifference) {
    return ChioOutcome::kFlank;
  }
  if (std::abs(chain.mean_rate) > kMaxRate + noise.mean) return ChioOutcome::kSteep;
  if (chain.rate_sigma > std::max(kMaxRateSigma, noise.sigma)) return ChioOutcome::kUneven;
  return ChioOutcome::kMatched;
}

CoreCandidates candidates_of(const CoreContext& context,
                             const EdgeSegment& left,
                             const std::vector<Candidate>& found) {
  const Screened screened{left, local_transfer(context.pair.search, midpoint(left.line.segment)),
                          searched_points(context.pair.search.right_from_left,
                                          ImageSampler(context.pair.left.image), left)};
  CoreCandidates result;
  result.gsd_m = screened.transfer.gsd_m;
  for (const Candidate& candidate : found) {
    if (candidate.overlap.aligned) {
      result.reason = std::max(result.reason, ChioOutcome::kEpipolarDegenerate);
      continue;
    }
    const ChainSummary chain =
        edge_chain(context.pair.search.right_from_left, screened.points, left.line,
                   context.pair.right.segments[candidate.right].line, result.gsd_m)
            .summary;
    const ChioOutcome verdict = screening(context, screened, candidate, chain);
    const bool may_begin = verdict == ChioOutcome::kMatched;
    if (!may_begin) result.reason = std::max(result.reason, verdict);
    if (may_begin || chain.n_reliable >= kMinLinkPieces) {
      result.list.push_back(
          {candidate.right, candidate.overlap, chain, candidate.similarity, may_begin});
    }
  }
  std::ranges::stable_sort(result.list, {}, [&](const CoreCandidate& c) {
    return context.beyond.by_appearance
               ? std::tuple(!c.may_begin, 0, -c.similarity)
               : std::tuple(!c.may_begin, -c.chain.n_reliable, c.chain.rate_sigma);
  });
  return result;
}

}  // namespace

const char* name(ChioOutcome outcome) {
  constexpr std::array kNames{
      "matched",      "no_candidate", "epipolar_degenerate", "few_pieces", "azimuth",   "flank",
      "steep",        "uneven",       "out_of_reach",        "height",     "low_score", "ambiguous",
      "lost_to_other"};
  return kNames.at(static_cast<std::size_t>(outcome));
}

std::vector<CoreCandidates> core_candidates(const SearchedPair& pair,
                                            const ChioOptions& options,
                                            const CandidateOptions& candidate_options,
                                            const ChioExtensions& beyond) {
  const Radiometry radiometry = relative_radiometry(pair.left.segments, pair.right.segments);
  const Candidates found =
      match_candidates(pair, radiometry, candidate_options, beyond.change_appearance,
                       beyond.by_appearance ? kMaxCandidates : kMaxCandidatesOfAnyAppearance);
  const CoreContext context{pair, radiometry, options, beyond};
  std::vector<CoreCandidates> candidates(pair.left.segments.size());
  tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
    candidates[i] = candidates_of(context, pair.left.segments[i], found[i]);
  });
  return candidates;
}

std::vector<int> linked_fragments(const CoreCandidates& candidates,
                                  int begin,
                                  const View& right,
                                  const ChioOptions& options,
                                  const ChioExtensions& beyond) {
  const CoreCandidate& first = candidates.list[begin];
  const Segment2& edge = right.segments[first.right].line.segment;
  const double first_noise = rate_noise(first.chain, candidates.gsd_m, beyond).mean;
  std::vector<int> fragments;
  for (std::size_t c = 0; c < candidates.list.size(); ++c) {
    const CoreCandidate& other = candidates.list[c];
    if (static_cast<int>(c) == begin || other.chain.n_reliable < kMinLinkPieces) continue;
    const double noise =
        std::hypot(first_noise, rate_noise(other.chain, candidates.gsd_m, beyond).mean);
    if (std::abs(other.chain.mean_rate - first.chain.mean_rate) > kMaxLinkRateDifference + noise) {
      continue;
    }
    const double turn_rad =
        std::abs(std::remainder(other.chain.azimuth_rad - first.chain.azimuth_rad, 2.0 * M_PI));
    if (turn_rad > options.max_azimuth_deg * kRadPerDeg) continue;
    if (!are_fragments(edge, right.segments[other.right].line.segment)) continue;
    fragments.push_back(static_cast<int>(c));
  }
  return fragments;
}

}  // namespace ridgeline::reconstruct
