// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/depth_consensus/depth_consensus.h"

#include "reconstruct/beyond/depth_consensus/bell.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kHorizontalSigma = 3.0;

/// Of lines that are not built horizontal: roofs of 20 to 50 degrees mostly, and streets.
double sloping(double slope) {
  constexpr double kRoof = 0.7, kRoofScatter = 0.3, kRoofShare = 0.9, kStreet = 0.6;
  return kRoofShare * bell((slope - kRoof) / kRoofScatter) +
         (1.0 - kRoofShare) * bell(slope / kStreet);
}

double log_prior(double slope, const ReconstructOptions& options) {
  const double p = options.horizontal_share;
  return std::log(p * bell(slope / options.sigma_slope) + (1.0 - p) * sloping(slope));
}

/// Through any two pieces of evidence, the horizontal line through each, and those that the strips beside the match speak
/// for.
std::vector<DepthHypothesis> hypotheses(const DepthQuestion& question, const DepthScorer& scorer) {
  const std::span<const DepthEvidence> evidence = question.evidence;
  std::vector<DepthHypothesis> all;
  const auto add = [&](const Eigen::Vector3d& through, const Eigen::Vector3d& direction) {
    all.push_back({{through, direction}, log_prior(slope(direction), question.options)});
  };
  const Eigen::Vector3d horizontal = scorer.horizontal();
  for (std::size_t a = 0; a < evidence.size(); ++a) {
    if (!horizontal.isZero()) add(evidence[a].x, horizontal);
    for (std::size_t b = a + 1; b < evidence.size(); ++b) {
      if (std::abs(evidence[a].parameter - evidence[b].parameter) < kSmallestBase) continue;
      add(evidence[a].x, scorer.in_plane(evidence[b].x - evidence[a].x));
    }
  }
  if (question.flanks != nullptr) {
    for (const DepthLine& line : question.flanks->likely_lines()) add(line.through, line.direction);
  }
  return all;
}

}  // namespace

std::optional<DepthConsensus> agree_on_depth(const DepthQuestion& question) {
  constexpr double kAnother_m = 1.0;
  const DepthScorer scorer(question);
  const std::vector<DepthHypothesis> all = hypotheses(question, scorer);
  if (all.empty()) return std::nullopt;
  std::vector<double> scores;
  scores.reserve(all.size());
  for (const DepthHypothesis& hypothesis : all) scores.push_back(scorer.score(hypothesis));
  const auto best = static_cast<std::size_t>(std::ranges::max_element(scores) - scores.begin());

  DepthConsensus consensus;
  consensus.line = all[best].line;
  consensus.horizontal =
      slope(consensus.line.direction) <= kHorizontalSigma * question.options.sigma_slope;
  for (std::size_t i = 0; i < question.evidence.size(); ++i) {
    if (scorer.supports(question.evidence[i], consensus.line)) consensus.supports.push_back(i);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (scorer.apart_m(all[i].line, consensus.line) <= kAnother_m) continue;
    consensus.margin = std::min(consensus.margin, scores[best] - scores[i]);
  }
  return consensus;
}

}  // namespace ridgeline::reconstruct
