// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/depth_consensus/flank_correlation.h"

#include "tests/reconstruct/support/flanked_line.h"
#include "tests/reconstruct/support/line_group.h"

#include <gmock/gmock.h>

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

using test::FlankedLine;
using test::kDegree;
using test::LineGroup;

constexpr double kHeightM = 6.0;
/// Half a pixel of parallax: the slope of the surface beside the line is not known.
constexpr double kFoundM = 0.15;
constexpr double kOutlier = 0.02;

/// A line of 100 px parallel to the epipolar line.
FlankedLine flanked(double start_z_m = kHeightM, double end_z_m = kHeightM) {
  FlankedLine flanked;
  flanked.line = make_segment(
      flanked.scene, {flanked.scene.left_centre(), 0.3 * kDegree, 100.0, start_z_m, end_z_m});
  return flanked;
}

/// The match of the line alone; nothing meets it.
LineGroup group_of(const FlankedLine& flanked) {
  LineGroup group;
  group.scene = flanked.scene;
  group.truth.push_back(flanked.line);
  observe(group, {}, nullptr);
  if (flanked.right_runs_back)
    std::swap(group.segments[1][0].segment.start, group.segments[1][0].segment.end);
  return group;
}

/// The joint line with the strips; segment ends that tell another depth than the line's.
ReconstructedLine reconstructed(const FlankedLine& flanked,
                                bool with_strips,
                                double shorter_px = 12.0) {
  LineGroup group = group_of(flanked);
  Segment2& left = group.segments[0][0].segment;
  left.end -= shorter_px * (left.end - left.start).normalized();
  const std::vector<FlankStrips> strips{flanked.strips()};
  return group.reconstruct(EstimationOptions{},
                           with_strips ? std::span(strips) : std::span<const FlankStrips>{})[0];
}

double worst_height_error_m(const FlankedLine& flanked, const ReconstructedLine& line) {
  double worst = 0.0;
  for (const double t : {0.1, 0.5, 0.8}) {
    worst = std::max(worst, std::abs(test::height_error_m(flanked.scene, *line.segment_in_local,
                                                          point_at(flanked.line, t))));
  }
  return worst;
}

TEST(FlankCorrelation, TellsTheHeightOfALineThatNothingMeets) {
  const FlankedLine eave = flanked();
  const ReconstructedLine without = reconstructed(eave, false);
  EXPECT_TRUE(without.status == Status::kAmbiguousDepth ||
              worst_height_error_m(eave, without) > 0.5);
  const ReconstructedLine line = reconstructed(eave, true);
  ASSERT_EQ(line.status, Status::kFlanks);
  EXPECT_LT(worst_height_error_m(eave, line), kFoundM);
}

TEST(FlankCorrelation, FollowsALineThatRises) {
  const FlankedLine verge = flanked(4.0, 8.0);
  const ReconstructedLine line = reconstructed(verge, true, 0.0);
  ASSERT_EQ(line.status, Status::kFlanks);
  EXPECT_LT(worst_height_error_m(verge, line), kFoundM);
}

TEST(FlankCorrelation, FollowsARoofThatFallsAwayFromTheLine) {
  FlankedLine eave = flanked();
  eave.roof_slope = -0.8;
  const ReconstructedLine line = reconstructed(eave, true);
  ASSERT_EQ(line.status, Status::kFlanks);
  EXPECT_LT(worst_height_error_m(eave, line), 0.3);  // a pixel
}

TEST(FlankCorrelation, SeesTheSameWhicheverWayTheRightSegmentRuns) {
  FlankedLine eave = flanked();
  eave.right_runs_back = true;
  const ReconstructedLine line = reconstructed(eave, true);
  ASSERT_EQ(line.status, Status::kFlanks);
  EXPECT_LT(worst_height_error_m(eave, line), kFoundM);
}

TEST(FlankCorrelation, SeesTheSameWhereTheImageEndsBesideTheLine) {
  FlankedLine eave = flanked();
  const Segment2 right = project(eave.scene.cameras[1], eave.line);
  eave.last_seen_x_px = std::max(right.start.x(), right.end.x()) - 25.0;
  const ReconstructedLine line = reconstructed(eave, true);
  ASSERT_EQ(line.status, Status::kFlanks);
  EXPECT_LT(worst_height_error_m(eave, line), kFoundM);
}

TEST(FlankCorrelation, SeesTheSameInAnImageOfAnotherGain) {
  FlankedLine eave = flanked();
  eave.gain_right = 0.6;
  EXPECT_LT(worst_height_error_m(eave, reconstructed(eave, true)), kFoundM);
}

/// The depth of the line in the conditioned frame of its match, and what the strips say of lines.
struct Asked {
  LineGroup group;
  StereoLines lines;
  std::optional<FlankCorrelation> flanks;

  explicit Asked(const FlankedLine& flanked) : group(group_of(flanked)) {
    const std::array<std::vector<Segment2>, 2> patch{
        std::vector<Segment2>{group.segments[0][0].segment},
        std::vector<Segment2>{group.segments[1][0].segment}};
    lines.stereo =
        condition(std::span<const ProjectionMatrix, 2>(group.scene.cameras), {patch[0], patch[1]});
    const std::array<ConditionedView, 2>& views = lines.stereo.views;
    lines.lines.push_back({observe(views[0], group.segments[0][0], LineCovariance::kEq1),
                           observe(views[1], group.segments[1][0], LineCovariance::kEq1)});
    flanks.emplace(lines, lines.lines[0], flanked.strips(), flanked.right_runs_back);
  }

  /// Of the line between two heights as the left camera sees it.
  double log_likelihood(double start_z_m, double end_z_m) const {
    const Segment2& left = group.segments[0][0].segment;
    const ObjectConditioning& object = lines.stereo.object;
    const Eigen::Vector3d start =
        object.conditioned_from_local(group.scene.at_height(left.start, start_z_m));
    const Eigen::Vector3d end =
        object.conditioned_from_local(group.scene.at_height(left.end, end_z_m));
    const DepthLine line{start, (end - start).normalized()};
    return flanks->log_likelihood([&](double) -> const DepthLine& { return line; });
  }
};

TEST(FlankCorrelation, PrefersTheUpperOfTwoSurfacesThatMeetAtALine) {
  const Asked asked(flanked());
  EXPECT_NEAR(asked.log_likelihood(kHeightM, kHeightM), 0.0, 0.05);
  // one side agrees with the ground, but the other one shows a surface above it
  EXPECT_LT(asked.log_likelihood(0.0, 0.0), -2.0);
  EXPECT_NEAR(asked.log_likelihood(2.5, 2.5), std::log(kOutlier), 0.2);
}

TEST(FlankCorrelation, TakesTheSurfaceOnBothSidesOfARidge) {
  FlankedLine ridge = flanked();
  ridge.has_ground = false;
  EXPECT_NEAR(Asked(ridge).log_likelihood(kHeightM, kHeightM), 0.0, 0.05);
}

TEST(FlankCorrelation, DoesNotTellALineAboveTheGroundFromOneOnItWithoutTextureAbove) {
  FlankedLine plain = flanked();
  plain.roof_is_plain = true;
  const Asked asked(plain);
  // the ground explains it; any height above costs the same
  EXPECT_NEAR(asked.log_likelihood(0.0, 0.0), 0.0, 0.05);
  EXPECT_NEAR(asked.log_likelihood(3.0, 3.0), asked.log_likelihood(9.0, 9.0), 0.05);
  EXPECT_GT(asked.log_likelihood(kHeightM, kHeightM), std::log(kOutlier));
}

TEST(FlankCorrelation, IsTheSameForARoofThatFallsAwayTheOtherDirectionTheBorderAndAnotherGain) {
  FlankedLine sloping = flanked();
  sloping.roof_slope = -0.8;
  FlankedLine reversed = flanked();
  reversed.right_runs_back = true;
  FlankedLine cut = flanked();
  const Segment2 right = project(cut.scene.cameras[1], cut.line);
  cut.last_seen_x_px = std::max(right.start.x(), right.end.x()) - 25.0;
  FlankedLine darker = flanked();
  darker.gain_right = 0.6;
  for (const FlankedLine& eave : {sloping, reversed, cut, darker}) {
    const Asked asked(eave);
    EXPECT_GT(asked.log_likelihood(kHeightM, kHeightM), -0.5);
    EXPECT_LT(asked.log_likelihood(2.5, 2.5), -2.0);
  }
}

TEST(FlankCorrelation, HasItsMaximumAtALineThatRises) {
  const Asked asked(flanked(4.0, 8.0));
  EXPECT_NEAR(asked.log_likelihood(4.0, 8.0), 0.0, 0.05);
  EXPECT_LT(asked.log_likelihood(6.0, 6.0), -2.0);
}

TEST(FlankCorrelation, HasTheLineAmongItsLikelyOnes) {
  for (const double end_z_m : {6.0, 9.0}) {
    const Asked asked(flanked(6.0, end_z_m));
    const auto worst_m = [&](const DepthLine& line) {
      const ObjectConditioning& object = asked.lines.stereo.object;
      const Segment3 far{object.local_from_conditioned(line.through),
                         object.local_from_conditioned(line.through + line.direction)};
      return std::abs(
          test::height_error_m(asked.group.scene, far, point_at(asked.group.truth[0], 0.5)));
    };
    constexpr double kStepM = 0.35;  // one pixel of parallax
    EXPECT_THAT(asked.flanks->likely_lines(),
                testing::Contains(testing::ResultOf(worst_m, testing::Lt(kStepM))));
  }
}

TEST(FlankCorrelation, AnEndThatTheBorderOfAnImageCutsShowsNoPoint) {
  for (const bool runs_back : {false, true}) {
    FlankedLine eave = flanked();
    eave.right_runs_back = runs_back;
    const LineGroup group = group_of(eave);
    std::vector<FlankStrips> strips(1);  // beside a line without texture
    const auto status = [&] { return group.reconstruct(EstimationOptions{}, strips)[0].status; };
    EXPECT_NE(status(), Status::kNoPoints);
    strips[0].left.is_cut = {true, false};             // where the left segment starts
    strips[0].right.is_cut = {runs_back, !runs_back};  // where it ends
    EXPECT_EQ(status(), Status::kNoPoints);
  }
}

TEST(FlankCorrelation, ALineThatOnlyAChanceAgreementSpeaksForIsAmbiguous) {
  const FlankedLine eave = flanked();
  const LineGroup group = group_of(eave);
  std::vector<FlankStrips> strips{eave.strips()};
  test::Random random(12);
  for (std::vector<float>& side : strips[0].right.sides) {
    for (float& value : side) value = static_cast<float>(random.uniform(0.3, 0.7));
  }
  strips[0].left.is_cut = {true, true};  // ends that show no point
  EstimationOptions options;
  options.beyond.min_depth_margin = 0.0;
  const ReconstructedLine line = group.reconstruct(options, strips)[0];
  EXPECT_EQ(line.status, Status::kAmbiguousDepth);
  EXPECT_FALSE(line.segment_in_local);
}

TEST(FlankCorrelation, SaysNothingWithoutStrips) {
  Asked asked(flanked());
  const FlankCorrelation none(asked.lines, asked.lines.lines[0], FlankStrips{}, false);
  EXPECT_TRUE(none.likely_lines().empty());
  const DepthLine line;
  EXPECT_EQ(none.log_likelihood([&](double) -> const DepthLine& { return line; }),
            std::log(kOutlier));
}

}  // namespace
}  // namespace ridgeline::reconstruct
