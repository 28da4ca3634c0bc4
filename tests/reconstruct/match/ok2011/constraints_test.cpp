// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/ok2011/constraints.h"

#include "reconstruct/match/ok2011/pair_similarity.h"
#include "tests/reconstruct/match/ok2011/stereo_pair.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kTol = 1e-12;
constexpr double kFloat = 1e-6;  // colours are floats

PairShape corner() {
  return {{{0.0, 0.0}, {30.0, 0.0}}, {{0.0, 0.0}, {0.0, 20.0}}, {0.0, 0.0}, true};
}

PairShape turned(PairShape pair, double angle_rad, double scale = 1.0) {
  const Eigen::Matrix2d m = scale * Eigen::Rotation2Dd(angle_rad).toRotationMatrix();
  for (Segment2* s : {&pair.first, &pair.second}) *s = {m * s->start, m * s->end};
  return pair;
}

TEST(EpipolarSimilarity, FallsWithTheDistanceInItsSigmas) {
  EXPECT_NEAR(*epipolar_similarity(0.0, 0.5), 1.0, kTol);
  // sigma of the pair: hypot(2, kMeetSigma_px)
  EXPECT_NEAR(*epipolar_similarity(std::sqrt(5.0), 2.0), std::exp(-0.5), kTol);
}

TEST(IntersectionSigma, IsThatOfTheOtherLineForAxesAtRightAngles) {
  UncertainSegment2 level;
  level.segment = {{-10.0, 0.0}, {10.0, 0.0}};
  level.centroid_px = {0.0, 0.0};
  level.sigma_q_px = 0.3;
  UncertainSegment2 upright;
  upright.segment = {{6.0, -10.0}, {6.0, 10.0}};
  upright.centroid_px = {6.0, 0.0};
  upright.sigma_q_px = 0.4;
  const Eigen::Vector2d x(6.0, 0.0);
  EXPECT_NEAR(intersection_sigma_px(level, upright, x, Eigen::Vector2d::UnitX()), 0.4, kTol);
  EXPECT_NEAR(intersection_sigma_px(level, upright, x, Eigen::Vector2d::UnitY()), 0.3, kTol);
  level.sigma_phi_rad = 0.1;  // 6 px from the centroid
  EXPECT_NEAR(intersection_sigma_px(level, upright, x, Eigen::Vector2d::UnitY()),
              std::hypot(0.3, 0.6), kTol);
}

TEST(AngleSimilarity, IgnoresRotationAndSeesTheSense) {
  EXPECT_NEAR(*angle_similarity(corner(), turned(corner(), 1.3)), 1.0, kTol);
  PairShape mirrored = corner();
  mirrored.second.end.y() *= -1.0;
  EXPECT_LT(*angle_similarity(corner(), mirrored), 1e-6);
  PairShape wider = corner();
  wider.second.end = 20.0 * Eigen::Vector2d(-std::sin(0.0873), std::cos(0.0873));  // 5 deg
  EXPECT_NEAR(*angle_similarity(corner(), wider), std::exp(-0.5), 1e-3);
}

TEST(GeometricConstraints, TolerateMoreByTheSpread) {
  PairShape wider = corner();
  wider.second.end = 20.0 * Eigen::Vector2d(-std::sin(0.0873), std::cos(0.0873));  // 5 deg
  PairShape apart = corner();
  apart.second = {{0.0, 20.0}, {0.0, 30.0}};
  // a Gaussian of twice the sigma is the fourth root of the Gaussian
  EXPECT_NEAR(std::pow(*angle_similarity(corner(), wider, 2.0), 4.0),
              *angle_similarity(corner(), wider), kTol);
  EXPECT_NEAR(std::pow(*direction_similarity(corner(), apart, 2.0), 4.0),
              *direction_similarity(corner(), apart), kTol);
  EXPECT_NEAR(std::pow(*extent_similarity(corner(), apart, 2.0), 4.0),
              *extent_similarity(corner(), apart), kTol);
  EXPECT_LT(*direction_similarity(corner(), apart), 0.9);
  EXPECT_LT(*extent_similarity(corner(), apart), 0.9);
}

TEST(ReliefSpread, GrowsWithTheBaseToHeightRatioFromThatOfTheCalibrationOn) {
  LocalTransfer transfer;
  transfer.gsd_m = 0.1;
  transfer.per_height = {0.0, 5.2};  // px/m: base to height ratio 0.52
  EXPECT_NEAR(relief_spread(transfer), 2.0, kTol);
  transfer.gsd_m = 0.02;  // 0.104
  EXPECT_EQ(relief_spread(transfer), 1.0);
}

TEST(DirectionSimilarity, ComparesTheDirectionFromMidpointToMidpoint) {
  EXPECT_NEAR(*direction_similarity(corner(), turned(corner(), -0.4, 1.2)), 1.0, kTol);
  PairShape shifted = corner();
  shifted.second.start.y() += 10.0;
  shifted.second.end.y() += 10.0;
  EXPECT_LT(*direction_similarity(corner(), shifted), 0.2);
}

TEST(ExtentSimilarity, IgnoresTheScaleAndSeesTheLengths) {
  EXPECT_NEAR(*extent_similarity(corner(), turned(corner(), 0.2, 3.0)), 1.0, kTol);
  PairShape shifted = corner();  // end points are farther apart, lengths are the same
  shifted.second.start.y() += 10.0;
  shifted.second.end.y() += 10.0;
  const double before = 50.0 / (0.25 * (0.0 + 20.0 + 30.0 + std::hypot(30.0, 20.0)));
  const double after =
      50.0 / (0.25 * (10.0 + 30.0 + std::hypot(30.0, 10.0) + std::hypot(30.0, 30.0)));
  const double in_sigmas = std::log(before / after) / 0.15;
  EXPECT_NEAR(*extent_similarity(corner(), shifted), std::exp(-0.5 * in_sigmas * in_sigmas), kTol);
}

TEST(GeometricConstraints, AreAbsentForNearAlignedMembersExceptTheAngle) {
  PairShape open = corner();
  open.clipped = false;
  EXPECT_TRUE(angle_similarity(corner(), open).has_value());
  EXPECT_FALSE(direction_similarity(corner(), open).has_value());
  EXPECT_FALSE(extent_similarity(open, corner()).has_value());
}

const EpipolarOverlap kSame{.on_left = {0.0, 1.0}, .on_right = {0.0, 1.0}};
const EpipolarOverlap kReversed{.on_left = {0.0, 1.0}, .on_right = {1.0, 0.0}};

EdgeSegment coloured(float left, float right) {
  EdgeSegment segment = test::edge({{0.0, 0.0}, {10.0, 0.0}});
  segment.left.colour.fill(left);
  segment.right.colour.fill(right);
  return segment;
}

TEST(ColourSimilarity, TakesTheBetterSide) {
  const Radiometry same;
  EXPECT_NEAR(*colour_similarity({coloured(0.2F, 0.8F), coloured(0.2F, 0.1F), kSame}, same), 1.0,
              kFloat);
  EXPECT_LT(*colour_similarity({coloured(0.2F, 0.8F), coloured(0.5F, 0.5F), kSame}, same), 0.01);
}

TEST(ColourSimilarity, ExchangesTheFlanksOfAReversedSegment) {
  const Radiometry same;
  EXPECT_NEAR(*colour_similarity({coloured(0.2F, 0.8F), coloured(0.8F, 0.2F), kReversed}, same),
              1.0, kFloat);
}

TEST(ContrastSimilarity, IsOneForTheSameStepAndZeroForItsOpposite) {
  const Radiometry same;
  EXPECT_NEAR(*contrast_similarity({coloured(0.2F, 0.8F), coloured(0.3F, 0.9F), kSame}, same), 1.0,
              kFloat);
  EXPECT_NEAR(*contrast_similarity({coloured(0.2F, 0.8F), coloured(0.8F, 0.2F), kSame}, same), 0.0,
              kFloat);
  EXPECT_NEAR(*contrast_similarity({coloured(0.2F, 0.8F), coloured(0.8F, 0.2F), kReversed}, same),
              1.0, kFloat);
  EXPECT_FALSE(
      contrast_similarity({coloured(0.4F, 0.4F), coloured(0.5F, 0.5F), kSame}, same).has_value());
}

PairPatch random_patch(std::uint64_t seed) {
  test::Random random(seed);
  PairPatch patch;
  patch.n_bands = 3;
  for (Colour& colour : patch.colours) {
    for (int band = 0; band < 3; ++band) {
      colour[band] = static_cast<float>(random.uniform(0.0, 1.0));
    }
  }
  return patch;
}

TEST(Correlation, IgnoresGainAndOffsetAndIsZeroForUnrelatedOrInverse) {
  const PairPatch patch = random_patch(1);
  PairPatch mapped = patch;
  PairPatch inverse = patch;
  for (Colour& c : mapped.colours) {
    for (float& value : c) value = 0.3F + 0.5F * value;
  }
  for (Colour& c : inverse.colours) {
    for (float& value : c) value = 1.0F - value;
  }
  EXPECT_NEAR(*correlation(patch, mapped), 1.0, kFloat);
  EXPECT_EQ(*correlation(patch, inverse), 0.0);
  EXPECT_LT(*correlation(patch, random_patch(2)), 0.2);  // 3.9 sigma of 432 samples
}

TEST(Correlation, IsAbsentWithoutTexture) {
  PairPatch flat;
  flat.n_bands = 1;
  for (Colour& c : flat.colours) c[0] = 0.5F;
  EXPECT_FALSE(correlation(flat, random_patch(1)).has_value());
}

TEST(SpatiogramSimilarity, IsOneForItselfAndInRangeForAll) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const PairPatch a = random_patch(seed);
    EXPECT_NEAR(*spatiogram_similarity(a, a), 1.0, 1e-9);
    const double s = *spatiogram_similarity(a, random_patch(seed + 100));
    EXPECT_GE(s, 0.0);
    EXPECT_LT(s, 1.0);
  }
}

TEST(SpatiogramSimilarity, SeesWhereTheColoursAre) {
  PairPatch top;  // dark above, bright below; the same histogram either way
  top.n_bands = 1;
  for (int i = 0; i < PairPatch::kNumSamples; ++i) {
    top.colours[i][0] = i < PairPatch::kNumSamples / 2 ? 0.1F : 0.9F;
  }
  PairPatch upside_down = top;
  for (Colour& c : upside_down.colours) c[0] = 1.0F - c[0];
  // two bins with half of the pixels each, 6 rows apart, variance of 6 rows (6^2 - 1) / 12 and the
  // floor of 1: N(mu; mu', 2 (S + S')) falls to exp(-6^2 / 2 / (4 var))
  const double variance = 35.0 / 12.0 + 1.0;
  EXPECT_NEAR(*spatiogram_similarity(top, upside_down), std::exp(-18.0 / (4.0 * variance)), 1e-9);
}

}  // namespace
}  // namespace ridgeline::reconstruct
