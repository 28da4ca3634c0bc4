// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/pair_similarity.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/match/ok2011/constraints.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr std::size_t kMaxMatchesPerPair = 5;
/// Longest side of the patch that a pair spans, because the surface is a plane only near the
/// corner.
constexpr double kMaxPatchSide_px = 32.0;

Segment2 clipped(const Segment2& s, const std::array<double, 2>& range) {
  return {point_at(s, range[0]), point_at(s, range[1])};
}

/// The members clipped to their overlaps, in ideal pixels or in file pixels.
struct Clipped {
  std::array<Segment2, 2> left, right;
};
Clipped clip(const EdgePair& a, const EdgePair& b, bool in_file) {
  const auto segment = [&](const EdgeSegment& edge) -> const Segment2& {
    return in_file ? edge.in_image : edge.line.segment;
  };
  return {
      {clipped(segment(a.left), a.overlap.on_left), clipped(segment(b.left), b.overlap.on_left)},
      {clipped(segment(a.right), a.overlap.on_right),
       clipped(segment(b.right), b.overlap.on_right)}};
}

/// Side of the patch along a member, from the intersection point to the far end, in both images. A
/// near-aligned member is assumed to be level, because its ends do not correspond.
struct PatchSides {
  Eigen::Vector2d left, right;
};
PatchSides patch_sides(const Segment2& left,
                       const Segment2& right,
                       const Eigen::Vector2d& x_left,
                       const Eigen::Vector2d& x_right,
                       bool aligned) {
  const bool start_is_far = (left.start - x_left).norm() > (left.end - x_left).norm();
  PatchSides sides{(start_is_far ? left.start : left.end) - x_left,
                   (start_is_far ? right.start : right.end) - x_right};
  const double shrink = std::min(1.0, kMaxPatchSide_px / sides.left.norm());
  sides.left *= shrink;
  if (aligned) {
    const double sign = sides.left.dot(left.end - left.start) < 0.0 ? -1.0 : 1.0;
    sides.right = sign * sides.left.norm() * along(right);
  } else {
    sides.right *= shrink;
  }
  return sides;
}

void add_patch_constraints(const PairScene& scene,
                           const EdgePair& a,
                           const EdgePair& b,
                           Constraints& constraints) {
  constexpr double kMinSide_px = 4.0;
  const Clipped pair = clip(a, b, true);
  const auto x_left = intersection(pair.left[0], pair.left[1], 0.0);
  const auto x_right = intersection(pair.right[0], pair.right[1], 0.0);
  if (!x_left || !x_right) return;
  const PatchSides first =
      patch_sides(pair.left[0], pair.right[0], *x_left, *x_right, a.overlap.aligned);
  const PatchSides second =
      patch_sides(pair.left[1], pair.right[1], *x_left, *x_right, b.overlap.aligned);
  for (const PatchSides* side : {&first, &second}) {
    if (std::min(side->left.norm(), side->right.norm()) < kMinSide_px) return;
  }
  const auto left = pair_patch(scene.images.left, {*x_left, first.left, second.left});
  if (!left) return;
  auto right = pair_patch(scene.images.right, {*x_right, first.right, second.right});
  if (!right) return;
  for (Colour& c : right->colours) c = scene.images.radiometry.left_from_right(c);
  constraints[6] = correlation(*left, *right);
  constraints[7] = spatiogram_similarity(*left, *right);
}

std::optional<double> mean(const std::optional<double>& a, const std::optional<double>& b) {
  if (a && b) return 0.5 * (*a + *b);
  return a ? a : b;
}

/// Distance of the intersection points from each other's epipolar lines, with its sigma.
struct EpipolarMisfit {
  double distance_px, sigma_px;
};
EpipolarMisfit epipolar_misfit(const PairScene& scene,
                               const EdgePair& a,
                               const EdgePair& b,
                               const Eigen::Vector2d& x_left,
                               const Eigen::Vector2d& x_right) {
  const Eigen::Matrix3d& right_from_left = scene.views.search.right_from_left.fundamental();
  const Eigen::Matrix3d left_from_right = right_from_left.transpose();
  const Eigen::Vector2d n_right = (right_from_left * x_left.homogeneous()).head<2>().normalized();
  const Eigen::Vector2d n_left = (left_from_right * x_right.homogeneous()).head<2>().normalized();
  return {0.5 * (epipolar_distance_px(right_from_left, x_left, x_right) +
                 epipolar_distance_px(left_from_right, x_right, x_left)),
          std::hypot(intersection_sigma_px(a.left.line, b.left.line, x_left, n_left),
                     intersection_sigma_px(a.right.line, b.right.line, x_right, n_right))};
}

/// All constraints of a pair of line matches; empty if it fails a gate.
std::optional<Constraints> constraints_of(const PairScene& scene,
                                          const EdgePair& a,
                                          const EdgePair& b) {
  constexpr double kMinAngle_rad = kMinPairAngle_deg * kRadPerDeg;
  const auto x_left = intersection(a.left.line.segment, b.left.line.segment, kMinAngle_rad);
  const auto x_right = intersection(a.right.line.segment, b.right.line.segment, kMinAngle_rad);
  if (!x_left || !x_right) return std::nullopt;
  const EpipolarMisfit misfit = epipolar_misfit(scene, a, b, *x_left, *x_right);
  if (misfit.distance_px > kMaxPairEpipolar_px) return std::nullopt;
  const Clipped pair = clip(a, b, false);
  const bool ends_correspond = !a.overlap.aligned && !b.overlap.aligned;
  const PairShape left{pair.left[0], pair.left[1], *x_left, ends_correspond};
  const PairShape right{pair.right[0], pair.right[1], *x_right, ends_correspond};
  const double turn_deg = std::abs(acute_angle_rad(left.first, left.second) -
                                   acute_angle_rad(right.first, right.second)) /
                          kRadPerDeg;
  if (turn_deg > scene.spread * kMaxPairTurn_deg) return std::nullopt;
  const Radiometry& radiometry = scene.images.radiometry;
  Constraints found;
  found[0] = epipolar_similarity(misfit.distance_px, misfit.sigma_px);
  found[1] = angle_similarity(left, right, scene.spread);
  found[2] = direction_similarity(left, right, scene.spread);
  found[3] = extent_similarity(left, right, scene.spread);
  found[4] = mean(colour_similarity(a, radiometry), colour_similarity(b, radiometry));
  found[5] = mean(contrast_similarity(a, radiometry), contrast_similarity(b, radiometry));
  add_patch_constraints(scene, a, b, found);
  return found;
}

}  // namespace

double weighted_similarity(const Constraints& constraints) {
  static constexpr std::array<double, kNumConstraints> kWeights = {1.1, 0.2, 1.2, 1.9,
                                                                   5.2, 5.6, 2.2, 0.2};
  double sum = 0.0;
  double weights = 0.0;
  for (int k = 0; k < kNumConstraints; ++k) {
    if (!constraints[k]) continue;
    sum += kWeights[k] * *constraints[k];
    weights += kWeights[k];
  }
  return weights > 0.0 ? sum / weights : 0.0;
}

double vote_of(double similarity) {
  constexpr double kEven = 0.77;  // at this similarity, as many pairs are correct as wrong
  // About the sum of the weights, which is the scale of the regression.
  constexpr double kSlope = 17.0;
  return 1.0 / (1.0 + std::exp(-kSlope * (similarity - kEven)));
}

double relief_spread(const LocalTransfer& transfer) {
  constexpr double kCalibrated = 0.26;
  return std::max(1.0, transfer.base_to_height() / kCalibrated);
}

std::vector<PairMatch> pair_matches(const PairScene& scene, const BasePair& pair) {
  std::vector<PairMatch> matches;
  const std::vector<Candidate>& firsts = scene.candidates[pair.first];
  const std::vector<Candidate>& seconds = scene.candidates[pair.second];
  for (std::size_t f = 0; f < firsts.size(); ++f) {
    for (std::size_t s = 0; s < seconds.size(); ++s) {
      if (firsts[f].right == seconds[s].right) continue;
      const auto member = [&](int left, const Candidate& c) {
        return EdgePair{scene.views.left.segments[left], scene.views.right.segments[c.right],
                        c.overlap};
      };
      const auto found =
          constraints_of(scene, member(pair.first, firsts[f]), member(pair.second, seconds[s]));
      if (!found) continue;
      matches.push_back(
          {pair, static_cast<int>(f), static_cast<int>(s), weighted_similarity(*found), *found});
    }
  }
  std::ranges::stable_sort(matches, std::greater{}, &PairMatch::similarity);
  if (matches.size() > kMaxMatchesPerPair) matches.resize(kMaxMatchesPerPair);
  return matches;
}

}  // namespace ridgeline::reconstruct
