// SPDX-License-Identifier: BSD-3-Clause
// Aligned lines whose neighbours do not all meet them, as eaves over the ground.
#include "reconstruct/estimate/beyond/depth_consensus/depth_consensus.h"

#include "reconstruct/estimate/beyond/depth_consensus/depth_profiles.h"
#include "tests/reconstruct/support/line_geometry.h"
#include "tests/reconstruct/support/line_group.h"

#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

using test::covariance_of;
using test::kDegree;
using test::LineGroup;
using test::make_group;
using test::NeighbourSpec;
using test::segment_of;
using test::SegmentSpec;

constexpr double kHeightM = 6.0;
constexpr double kRecoveredM = 1e-6;
constexpr double kAssumedM = 1e-3;  // horizontality is weighted, not forced

const test::StereoScene kScene;

/// A horizontal line of 100 px at this angle to the epipolar direction.
SegmentSpec eave(double theta_deg) {
  return {kScene.left_centre(), theta_deg * kDegree, 100.0, kHeightM, kHeightM};
}

/// Lets the line at the parameter seem to meet a line of the ground, which it hides from there on.
void add_ground_line(LineGroup& group, double parameter, double angle_deg) {
  const Segment3 line = group.truth[0];
  const Eigen::Vector2d x = project(group.scene.cameras[0], point_at(line, parameter));
  const Eigen::Vector2d direction =
      Eigen::Rotation2Dd(angle_deg * kDegree) * group.scene.epipolar_direction(x);
  const Segment3 ground{group.scene.at_height(x, 0.0),
                        group.scene.at_height(x + 60.0 * direction, 0.0)};
  const int i = static_cast<int>(group.truth.size());
  group.truth.push_back(ground);
  const std::array<Segment2, 2> images = group.scene.images(ground);
  for (std::size_t j = 0; j < 2; ++j) group.segments[j].push_back(test::exact(images[j], {}));
  group.matches.push_back({i, i});
  group.connections.push_back({0, i});
}

double worst_error_m(const LineGroup& group, const ReconstructedLine& line) {
  return std::max((segment_of(line).start - group.truth[0].start).norm(),
                  (segment_of(line).end - group.truth[0].end).norm());
}

TEST(DepthConsensus, LeavesOutThePointThatDisagrees) {
  LineGroup group = make_group(eave(0.5), {{0.0, 80}, {1.0, 110}});
  add_ground_line(group, 0.5, 70.0);
  // in the published method all three regions give a point, and the false one bends the line
  EXPECT_GT(worst_error_m(group, group.reconstruct(test::published())[0]), 1.0);
  const ReconstructedLine line = group.reconstruct(EstimationOptions{})[0];
  EXPECT_STREQ(status_name(line), "joint");
  EXPECT_EQ(line.points.size(), 2U);
  EXPECT_LT(worst_error_m(group, line), kRecoveredM);
}

TEST(DepthConsensus, IsNotOutvotedByPointsOfOneFalseSurface) {
  LineGroup group = make_group(eave(0.5), {{0.0, 80}, {1.0, 110}});
  for (const double parameter : {0.25, 0.4, 0.55, 0.7}) add_ground_line(group, parameter, 70.0);
  const ReconstructedLine line = group.reconstruct(EstimationOptions{})[0];
  ASSERT_STREQ(status_name(line), "joint");
  EXPECT_LT(worst_error_m(group, line), kRecoveredM);
}

/// A line that meets nothing. Its start has its true height in both images, its end another height.
LineGroup with_ends_that_disagree(double other_m) {
  LineGroup group = make_group(eave(0.5), {});
  const Eigen::Vector2d end = group.segments[0][0].segment.end;
  group.segments[1][0].segment.end =
      project(group.scene.cameras[1], group.scene.at_height(end, other_m));
  return group;
}

TEST(DepthConsensus, CountsHowFarLinesThatMeetMissEachOther) {
  constexpr int kTrials = 400;
  constexpr double kMinMean = 0.7,
                   kMaxMean = 1.3;  // around the mean 1; a chi-square mean of 300 scatters by 0.08
  const EstimationOptions options;
  test::Random random(71);
  double sum = 0.0;
  int n = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const LineGroup group = test::make_group_with_misses(test::line_at(0.5), test::kThreeNeighbours,
                                                         options.building.sigma_meeting_m,
                                                         test::scaled({}, 0.2), random);
    const ReconstructedLine line = group.reconstruct(options)[0];
    if (line.determination != Determination::kJoint) continue;
    const Segment3& s = segment_of(line);
    const double off_m = test::height_error_m(group.scene, group.truth[0], point_at(s, 0.5));
    const auto& cov = covariance_of(line);
    sum += off_m * off_m / (0.25 * (cov(2, 2) + cov(5, 5) + 2.0 * cov(2, 5)));
    ++n;
  }
  ASSERT_GT(n, kTrials / 2);
  EXPECT_GT(sum / n, kMinMean);
  EXPECT_LT(sum / n, kMaxMean);
}

TEST(DepthConsensus, GivesNoLineWhereAnotherDepthExplainsItAboutAsWell) {
  const ReconstructedLine line = with_ends_that_disagree(3.0).reconstruct(EstimationOptions{})[0];
  EXPECT_STREQ(status_name(line), "ambiguous_depth");
  EXPECT_FALSE(line.segment_in_local);
  EXPECT_FALSE(line.covariance_m2);
  EXPECT_FALSE(line.other_segment_in_local);
}

TEST(DepthConsensus, TakesALineWithOnePointAsHorizontalIfItsEndsAgree) {
  const LineGroup group = make_group(eave(0.5), {{0.0, 80}});
  const ReconstructedLine line = group.reconstruct(EstimationOptions{})[0];
  EXPECT_STREQ(status_name(line), "horizontal");
  EXPECT_EQ(line.points.size(), 1U);
  EXPECT_LT(worst_error_m(group, line), kAssumedM);
}

TEST(DepthConsensus, HorizontalitySteadiesPointsThatAgreeOnIt) {
  const LineGroup group = make_group(eave(0.5), {{0.3, 80}, {0.7, 110}});
  const auto sigma_slope = [&](const EstimationOptions& options) {
    const ReconstructedLine line = group.reconstruct(options)[0];
    EXPECT_STREQ(status_name(line), "joint");
    Vector6d rise = Vector6d::Zero();
    rise[2] = -1.0 / length(segment_of(line));
    rise[5] = -rise[2];
    return std::sqrt(rise.dot(covariance_of(line) * rise));
  };
  const EstimationOptions options;
  EXPECT_LE(sigma_slope(options), options.building.sigma_slope);
  EXPECT_GT(sigma_slope(test::published()), 1.2 * options.building.sigma_slope);
}

TEST(DepthConsensus, DoesNotForceASlopingLineToBeHorizontal) {
  SegmentSpec verge = eave(0.5);
  verge.end_z_m = kHeightM + 4.0;
  const LineGroup group = make_group(verge, {{0.0, 80}, {1.0, 110}});
  const ReconstructedLine line = group.reconstruct(EstimationOptions{})[0];
  EXPECT_STREQ(status_name(line), "joint");
  EXPECT_LT(worst_error_m(group, line), kRecoveredM);
}

TEST(DepthConsensus, DoesNotTakeTwoPointsInOnePlaceForADirection) {
  // the two meetings lie in two regions, but only a tenth of the segment apart
  const LineGroup group = make_group(eave(0.5), {{0.28, 80}, {0.38, 110}});
  const ReconstructedLine line = group.reconstruct(EstimationOptions{})[0];
  EXPECT_EQ(line.points.size(), 2U);
  EXPECT_STREQ(status_name(line), "horizontal");
}

TEST(DepthConsensus, DoesNotDependOnTheDirectionOfTheSegments) {
  LineGroup group = make_group(eave(0.5), {});
  const ReconstructedLine expected = group.reconstruct(EstimationOptions{})[0];
  Segment2& right = group.segments[1][0].segment;
  std::swap(right.start, right.end);
  const ReconstructedLine line = group.reconstruct(EstimationOptions{})[0];
  EXPECT_STREQ(status_name(line), status_name(expected));
  EXPECT_LT(worst_error_m(group, line), kAssumedM);
}

TEST(DepthConsensus, TakesALineWithoutPointsFromItsEnds) {
  const LineGroup group = make_group(eave(0.5), {});
  const ReconstructedLine line = group.reconstruct(EstimationOptions{})[0];
  EXPECT_STREQ(status_name(line), "horizontal");
  EXPECT_TRUE(line.points.empty());
  EXPECT_LT(worst_error_m(group, line), kAssumedM);
}

TEST(DepthConsensus, EndsOfAShortSegmentProveNothing) {
  SegmentSpec step = eave(0.5);
  step.length_px = 12.0;
  EXPECT_STREQ(status_name(make_group(step, {}).reconstruct(EstimationOptions{})[0]),
               "ambiguous_depth");
  // with a point beside them they do
  const ReconstructedLine line = make_group(step, {{0.0, 80}}).reconstruct(EstimationOptions{})[0];
  EXPECT_STREQ(status_name(line), "horizontal");
}

/// One line alone, and evidence on it.
struct LoneLine {
  TrackedLines lines;
  std::array<Segment2, 2> images;

  LoneLine() : images(kScene.images(make_segment(kScene, eave(0.5)))) {
    lines.frames =
        condition(kScene.cameras, std::array{std::vector{images[0]}, std::vector{images[1]}});
    ObservedTrack& observed = lines.lines.emplace_back();
    for (std::size_t j = 0; j < 2; ++j) {
      observed.observations.push_back(
          observe(lines.frames, j, test::exact(images[j], {}), LineCovariance::kEq1));
    }
  }

  [[nodiscard]] std::optional<DepthConsensus> consensus(std::span<const DepthEvidence> evidence,
                                                        std::span<const double> nearby = {}) const {
    return agree_on_depth(
        {lines, lines.lines[0], evidence, nearby, ConsensusOptions{}, BuildingOptions{}});
  }

  /// A point seen at a parameter of the left segment, at this height.
  [[nodiscard]] DepthEvidence evidence_at(double parameter, double z_m) const {
    const ObjectConditioning& object = lines.frames.object;
    const Eigen::Vector2d x = images[0].start + parameter * (images[0].end - images[0].start);
    const double sigma = 0.05 / object.scale_m;
    return {object.conditioned_from_local(kScene.at_height(x, z_m)),
            sigma * sigma * Eigen::Matrix3d::Identity(), parameter, 0.5};
  }
};

TEST(AgreeOnDepth, PrefersTheHeightsOfLinesNearby) {
  const LoneLine line;
  const std::vector<DepthEvidence> evidence{line.evidence_at(0.1, kHeightM),
                                            line.evidence_at(0.2, 0.0)};
  for (const std::size_t right : {0U, 1U}) {
    const std::vector<double> nearby{evidence[right].x.z()};
    const auto consensus = line.consensus(evidence, nearby);
    ASSERT_TRUE(consensus);
    ASSERT_EQ(consensus->parts.size(), 1U);
    EXPECT_TRUE(consensus->parts[0].horizontal);
    EXPECT_THAT(consensus->parts[0].supports, testing::ElementsAre(right));
  }
  EXPECT_FALSE(line.consensus({}));
}

TEST(AgreeOnDepth, OfTwoLinesThatEndThereTheHigherOneCannotPassBehind) {
  const LoneLine line;
  std::vector<DepthEvidence> evidence{line.evidence_at(0.1, 0.0), line.evidence_at(0.2, kHeightM)};
  for (DepthEvidence& e : evidence) e.meeting = 1.0;
  const auto consensus = line.consensus(evidence);
  ASSERT_TRUE(consensus);
  EXPECT_THAT(consensus->parts.at(0).supports, testing::ElementsAre(1U));
  EXPECT_GT(consensus->margin, ConsensusOptions{}.min_depth_margin);
  // if the meetings say nothing of what hides what, neither height is better
  for (DepthEvidence& e : evidence) e.meeting = 0.0;
  EXPECT_LT(line.consensus(evidence)->margin, ConsensusOptions{}.min_depth_margin);
}

TEST(RowProfile, IsNoneWithoutRoomForASecondStep) {
  const LoneLine line;
  const ConsensusOptions options;
  const BuildingOptions building;
  const auto has_row_cut_at = [&](double parameter) {
    std::vector<DepthEvidence> evidence{line.evidence_at(0.0, kHeightM),
                                        line.evidence_at(parameter, kHeightM)};
    evidence[1].may_cut = true;
    const DepthQuestion question{line.lines, line.lines.lines[0], evidence, {}, options, building};
    return row_profile(question, DepthScorer(question)).has_value();
  };
  EXPECT_TRUE(has_row_cut_at(0.5));
  EXPECT_FALSE(has_row_cut_at(0.1));  // 10 px
}

TEST(DepthConsensus, OfEndsThatDisagreeTheHeightOfALineNearbyDecides) {
  constexpr double kOtherM = 3.0;  // height that the ends of both images would show
  const LineGroup group = with_ends_that_disagree(kOtherM);
  for (const double height_m : {kHeightM, kOtherM}) {
    LineGroup with = group;
    const Eigen::Vector2d beside = kScene.left_centre() + Eigen::Vector2d(0.0, 40.0);
    const Segment3 nearby{kScene.at_height(beside, height_m),
                          kScene.at_height(beside + Eigen::Vector2d(0.0, 60.0), height_m)};
    const std::array<Segment2, 2> images = kScene.images(nearby);
    for (std::size_t j = 0; j < 2; ++j) with.segments[j].push_back(test::exact(images[j], {}));
    with.matches.push_back({1, 1});  // the line is not connected and meets nothing
    EstimationOptions options;
    options.consensus.min_depth_margin = 0.0;  // a weak reason alone
    const ReconstructedLine line = with.reconstruct(options)[0];
    ASSERT_TRUE(line.segment_in_local) << height_m;
    EXPECT_NEAR(segment_of(line).start.z(), height_m, 0.1) << height_m;
    EXPECT_NEAR(segment_of(line).end.z(), height_m, 0.1) << height_m;
  }
}

/// Part of a line across the first one, by distances beside the middle of the first one, px.
using Stretch = std::array<double, 2>;

/// Adds a rising line whose left segment is longer than the right one. The middle of the right one
/// has a given height. The line is not connected and meets nothing.
void add_line_with_short_counterpart(LineGroup& group,
                                     Stretch left,
                                     Stretch right,
                                     double height_m) {
  constexpr double kRiseM = 0.005;  // per pixel
  const Eigen::Vector2d across =
      Eigen::Rotation2Dd(90.0 * kDegree) * kScene.epipolar_direction(kScene.left_centre());
  const auto line = [&](const Stretch& s) {
    const auto at = [&](double beside_px) {
      const double z_m = height_m + kRiseM * (beside_px - 0.5 * (right[0] + right[1]));
      return kScene.at_height(kScene.left_centre() + beside_px * across, z_m);
    };
    return Segment3{at(s[0]), at(s[1])};
  };
  const auto i = static_cast<int>(group.matches.size());
  const test::Noise noise;  // noise of 100 px; that of a direction goes with length^-1.5
  const double shorter = (right[1] - right[0]) / 100.0;
  group.segments[0].push_back(test::exact(kScene.images(line(left))[0], noise));
  group.segments[1].push_back(
      test::exact(kScene.images(line(right))[1],
                  {noise.q_px, noise.phi_rad / std::pow(shorter, 1.5), noise.e_px}));
  group.matches.push_back({i, i});
}

/// Heights of both ends of the first line, beside a line with a short counterpart at a height.
std::array<double, 2> heights_beside(Stretch left, Stretch right, double height_m) {
  LineGroup group = with_ends_that_disagree(3.0);
  add_line_with_short_counterpart(group, left, right, height_m);
  EstimationOptions options;
  options.consensus.min_depth_margin = 0.0;  // a weak reason alone
  const std::vector<ReconstructedLine> lines = group.reconstruct(options);
  EXPECT_LT(length(segment_of(lines[1])), length(*lines[1].other_segment_in_local) + 0.1);
  EXPECT_LT(*lines[1].direct_sigma_z_m, 0.4);  // m; the height is known well enough to compare
  return {segment_of(lines[0]).start.z(), segment_of(lines[0]).end.z()};
}

TEST(DepthConsensus, HeightsNearbyAreThoseOfEndsThatBothImagesShow) {
  // within 100 px is near: both ends of the left segment are farther off, those of its counterpart
  // are near
  const Stretch whole{-120.0, 200.0};
  for (const double height_m : {kHeightM, 3.0}) {
    EXPECT_THAT(heights_beside(whole, {25.0, 55.0}, height_m),
                testing::Each(testing::DoubleNear(height_m, 0.1)));
  }
}

TEST(DepthConsensus, HeightsNearbyAreNotThoseOfWhatIsFarAway) {
  // an end of the left segment is near, but the end of its counterpart, whose height is known, is
  // not
  const Stretch whole{40.0, 360.0};
  EXPECT_EQ(heights_beside(whole, {200.0, 230.0}, kHeightM)[0] > 4.5,
            heights_beside(whole, {200.0, 230.0}, 3.0)[0] > 4.5);
}

TEST(DepthConsensus, ChangesNoLineThatIsNotAligned) {
  const LineGroup group = make_group(eave(30.0), {{0.0, 80}, {1.0, 110}});
  const ReconstructedLine published = group.reconstruct(test::published())[0];
  EstimationOptions options;
  options.beyond.common_part = false;
  const ReconstructedLine line = group.reconstruct(options)[0];
  EXPECT_STREQ(status_name(line), "direct");
  EXPECT_EQ(segment_of(line).start, segment_of(published).start);
  EXPECT_EQ(segment_of(line).end, segment_of(published).end);
}

TEST(DepthConsensus, NeverLosesALineThatDirectHasUnlessItIsAmbiguous) {
  test::Random random(7);
  EstimationOptions decide;
  decide.consensus.min_depth_margin = 0.0;
  for (int i = 0; i < 200; ++i) {
    const LineGroup group = make_group(eave(0.3 + 0.04 * i), {}, {}, &random);
    EXPECT_TRUE(group.reconstruct(decide)[0].segment_in_local) << i;
  }
}

}  // namespace
}  // namespace ridgeline::reconstruct
