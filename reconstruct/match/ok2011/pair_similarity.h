// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/match/candidates.h"
#include "reconstruct/match/ok2011/base_pairs.h"

#include <array>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// The constraints in the order of constraints.h.
inline constexpr int kNumConstraints = 8;
using Constraints = std::array<std::optional<double>, kNumConstraints>;

/// S = sum w_k s_k / sum w_k over the constraints that are present; 0 if none is. The weights are
/// those of a logistic regression over the candidate pairs of the simulated training scenes (seeds
/// 1 to 8), with negative ones raised to 0.2.
double weighted_similarity(const Constraints& constraints);

/// The vote of a pair match of similarity S: the probability, in [0, 1], that both its members are
/// correct.
double vote_of(double similarity);

/// A pair of the left image with a candidate for each of its members.
struct PairMatch {
  BasePair pair;
  int first_candidate = 0;  ///< index into the candidates of pair.first
  int second_candidate = 0;
  double similarity = 0.0;  ///< S, in [0, 1]
  Constraints constraints;
};

/// Gates of a pair match; they are ours, because Ok et al. 2011, section 2, give no numbers. The
/// largest difference of the enclosed angles applies up to a base-to-height ratio of 0.26; see
/// relief_spread().
inline constexpr double kMaxPairTurn_deg = 15.0;
inline constexpr double kMaxPairEpipolar_px = 5.0;

/// A stereo pair as input of the pair-wise constraints.
struct PairScene {
  const SearchedPair& views;
  ImagePair images;
  const Candidates& candidates;
  /// Multiplies the spreads of the geometric constraints and kMaxPairTurn_deg.
  double spread = 1.0;
};

/// How much more the shape of a pair changes between the images than at a base-to-height ratio of
/// 0.26, for which the geometric constraints are calibrated. Never less than 1, because the noise
/// remains.
double relief_spread(const LocalTransfer& transfer);

/// The candidate pairs of a base pair, best first, at most five. Each consists of two different
/// right segments that form a pair in the right image and pass the gates on the enclosed angle and
/// the epipolar distance of the intersection points.
std::vector<PairMatch> pair_matches(const PairScene& scene, const BasePair& pair);

}  // namespace ridgeline::reconstruct
