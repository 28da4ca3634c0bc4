// SPDX-License-Identifier: BSD-3-Clause
// Method::kNetwork on groups of lines whose truth is known.
#include "reconstruct/estimate/beyond/network/network.h"

#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "tests/reconstruct/support/conditioned_scene.h"
#include "tests/reconstruct/support/line_geometry.h"
#include "tests/reconstruct/support/line_group.h"
#include "tests/reconstruct/support/nees.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

using test::covariance_of;
using test::kThreeNeighbours;
using test::line_at;
using test::LineGroup;
using test::make_group;
using test::segment_of;

/// More neighbours than `joint` takes points from, so that `network` knows more.
const std::vector<test::NeighbourSpec> kFiveNeighbours{
    {0.05, 80}, {0.5, -60}, {0.95, 110}, {0.05, -70}, {0.95, -80}};

EstimationOptions network_options() {
  EstimationOptions options;
  options.lines.line_covariance = LineCovariance::kCentroid;
  options.lines.method = Method::kNetwork;
  return options;
}

double largest_error_m(const ReconstructedLine& line, const Segment3& truth) {
  return std::max((segment_of(line).start - truth.start).norm(),
                  (segment_of(line).end - truth.end).norm());
}

/// The larger distance of the two ends from the true line. Along it the ends scatter as those in
/// the image do.
double error_across_m(const ReconstructedLine& line, const Segment3& truth) {
  const Eigen::Vector3d along = (truth.end - truth.start).normalized();
  return std::max((segment_of(line).start - truth.start).cross(along).norm(),
                  (segment_of(line).end - truth.start).cross(along).norm());
}

/// A group whose neighbours end on the line and miss it by half of sigma_meeting_m, as such ends
/// do.
LineGroup group_with_misses(double theta_deg,
                            const std::vector<test::NeighbourSpec>& neighbours,
                            const test::Noise& noise,
                            const EstimationOptions& options,
                            test::Random& random) {
  return test::make_group_with_misses(line_at(theta_deg), neighbours,
                                      0.5 * options.building.sigma_meeting_m, noise, random);
}

TEST(Network, RecoversLinesWithoutErrorAtAnyAngle) {
  constexpr double kRounding_m = 1e-6;  // the range of heights of 200 km is a weak prior
  for (const double theta_deg : {60.0, 20.0, 6.0, 2.0, 0.5, 0.0}) {
    const LineGroup group = make_group(line_at(theta_deg), kFiveNeighbours);
    const auto lines = group.reconstruct(network_options());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      ASSERT_STREQ(status_name(lines[i]), "network") << theta_deg;
      EXPECT_EQ(lines[i].n_meetings, i == 0 ? 5 : 1);
      EXPECT_LT(largest_error_m(lines[i], group.truth[i]), kRounding_m) << theta_deg;
    }
  }
}

TEST(Network, LinesThatMeetNoneStayAsTheyAre) {
  test::Random random(331);
  LineGroup group = make_group(line_at(40), kThreeNeighbours, {}, &random);
  group.connections.clear();
  EstimationOptions joint = network_options();
  joint.lines.method = Method::kJoint;
  const auto expected = group.reconstruct(joint);
  const auto actual = group.reconstruct(network_options());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_STREQ(status_name(actual[i]), status_name(expected[i]));
    EXPECT_EQ(segment_of(actual[i]).start, segment_of(expected[i]).start);
    EXPECT_EQ(covariance_of(actual[i]), covariance_of(expected[i]));
  }
}

TEST(Network, LineThatHasNoMoreMeetingsThanPointsStaysAsJointGivesIt) {
  const LineGroup group = make_group(line_at(4), {kThreeNeighbours[0], kThreeNeighbours[2]});
  EstimationOptions joint = network_options();
  joint.lines.method = Method::kJoint;
  const auto expected = group.reconstruct(joint);
  const auto actual = group.reconstruct(network_options());
  ASSERT_EQ(expected[0].points.size(), 2U);
  EXPECT_STREQ(status_name(actual[0]), "joint");
  EXPECT_EQ(segment_of(actual[0]).start, segment_of(expected[0]).start);
  EXPECT_STREQ(status_name(actual[1]), "network");
}

class NetworkPrecision : public testing::TestWithParam<double> {};

TEST_P(NetworkPrecision, StatesItsErrors) {
  constexpr int kTrials = 600;
  const EstimationOptions options = network_options();
  test::Random random(332);
  double sum = 0.0;
  int n = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const LineGroup group =
        group_with_misses(GetParam(), kFiveNeighbours, test::scaled({}, 0.3), options, random);
    const auto lines = group.reconstruct(options);
    // only lines with all meetings accepted count: a miss of 3 sigma is rejected, so the others are
    // not normal
    if (lines[0].n_meetings < 5) continue;
    sum += test::nees(lines[0], group.truth[0]);
    ++n;
  }
  ASSERT_GT(n, 0.85 * kTrials);  // lines with five meetings each
  EXPECT_NEAR(sum / n, 4.0, test::chi_square_mean_band(4.0, n));
}

INSTANTIATE_TEST_SUITE_P(Angles, NetworkPrecision, testing::Values(45.0, 20.0, 6.0, 2.0, 0.0));

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

TEST(Network, IsMoreAccurateThanJointWhereThatHasNoPoints) {
  constexpr int kTrials = 300;
  test::Random random(333);
  EstimationOptions joint = network_options();
  joint.lines.method = Method::kJoint;
  std::vector<double> before_m;
  std::vector<double> after_m;
  for (int trial = 0; trial < kTrials; ++trial) {
    const LineGroup group =
        group_with_misses(random.uniform(11, 25), kThreeNeighbours, {}, network_options(), random);
    before_m.push_back(error_across_m(group.reconstruct(joint)[0], group.truth[0]));
    after_m.push_back(error_across_m(group.reconstruct(network_options())[0], group.truth[0]));
  }
  EXPECT_LT(median(after_m), 0.5 * median(before_m));
}

TEST(Network, IsAsAccurateAsJointWithSomeOfTheFivePoints) {
  constexpr int kTrials = 300;
  test::Random random(337);
  EstimationOptions joint = network_options();
  joint.lines.method = Method::kJoint;
  std::vector<double> before_m;
  std::vector<double> after_m;
  for (int trial = 0; trial < kTrials; ++trial) {
    const LineGroup group =
        group_with_misses(random.uniform(0, 9), kFiveNeighbours, {}, network_options(), random);
    const ReconstructedLine before = group.reconstruct(joint)[0];
    const ReconstructedLine after = group.reconstruct(network_options())[0];
    // a line without a depth stays without one: its five meetings are about as many as points that
    // disagree
    ASSERT_EQ(after.segment_in_local.has_value(), before.segment_in_local.has_value()) << trial;
    if (!before.segment_in_local) continue;
    before_m.push_back(error_across_m(before, group.truth[0]));
    after_m.push_back(error_across_m(after, group.truth[0]));
  }
  ASSERT_GT(before_m.size(), 0.9 * kTrials);
  EXPECT_LT(median(after_m), 1.05 * median(before_m));
  // a rejected meeting must not leave a line with fewer constraints than `joint` had
  EXPECT_LT(*std::max_element(after_m.begin(), after_m.end()),
            1.5 * *std::max_element(before_m.begin(), before_m.end()));
}

TEST(Network, RejectsAFalseMeetingAmongFour) {
  constexpr int kTrials = 200;
  test::Random random(334);
  const std::vector<test::NeighbourSpec> neighbours{
      {0.05, 80}, {0.35, -60}, {0.65, 110}, {0.95, 70}};
  EstimationOptions options;  // with the consensus, from which `network` starts
  options.lines.method = Method::kNetwork;
  for (const double theta_deg : {30.0, 4.0}) {
    int rejected = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      test::SegmentSpec level = line_at(theta_deg);  // eaves and ridges are level
      level.end_z_m = level.start_z_m;
      LineGroup group = make_group(level, neighbours);
      // the line is an eave over the ground: the two cross in both images only because the eave
      // hides what is below
      const auto wrong = static_cast<std::size_t>(1 + trial % 4);
      const Eigen::Vector3d below(0, 0, -5.0);
      group.truth[wrong] = {group.truth[wrong].start + below, group.truth[wrong].end + below};
      for (auto& segments : group.segments) segments.clear();
      group.matches.clear();
      test::observe(group, {}, &random);
      const auto lines = group.reconstruct(options);
      // line 0 stays as `joint` gives it: three meetings are no more than its points
      const auto n_met = std::ranges::count_if(
          std::span(lines).subspan(1), [](const auto& line) { return line.n_meetings == 1; });
      if (lines[wrong].n_meetings == 0 && n_met >= 2) ++rejected;
    }
    EXPECT_GE(rejected, 0.95 * kTrials) << theta_deg;
  }
}

TEST(Network, FalseMeetingsThatAgreeDoNotMoveALine) {
  constexpr int kTrials = 200;
  test::Random random(338);
  int kept = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    test::SegmentSpec level = line_at(30.0);
    level.end_z_m = level.start_z_m;
    // a road marking, and edges of parked cars and vans that seem to end on it
    LineGroup group = make_group(level, {{0.1, 80}, {0.35, -60}, {0.65, 110}, {0.9, 70}});
    const Eigen::Vector3d above(0.0, 0.0, 1.5);
    for (std::size_t k = 1; k < group.truth.size(); ++k)
      group.truth[k] = {group.truth[k].start + above, group.truth[k].end + above};
    for (auto& segments : group.segments) segments.clear();
    group.matches.clear();
    test::observe(group, {}, &random);
    if (group.reconstruct(network_options())[0].n_meetings == 0) ++kept;
  }
  EXPECT_GE(kept, 0.95 * kTrials);
}

TEST(Network, GroupsThatNothingConnectsDoNotInfluenceEachOther) {
  // the larger patch is conditioned otherwise, which deviations feel to the second order
  constexpr double kSecondOrder_m = 1e-3;
  test::Random random(335);
  LineGroup both = make_group(line_at(5), kThreeNeighbours, {}, &random);
  const auto alone = both.reconstruct(network_options());
  // the same again elsewhere, connected among themselves only
  const LineGroup second = make_group(
      {both.scene.left_centre() + Eigen::Vector2d(30, 30), 5 * test::kDegree, 100.0, 3.0, 4.0},
      kThreeNeighbours, {}, &random);
  for (std::size_t i = 0; i < second.truth.size(); ++i) {
    for (std::size_t j = 0; j < 2; ++j) both.segments[j].push_back(second.segments[j][i]);
    both.matches.push_back({static_cast<int>(4 + i), static_cast<int>(4 + i)});
    both.truth.push_back(second.truth[i]);
  }
  for (const PairConnection& c : second.connections) both.connections.push_back({4 + c.i, 4 + c.k});
  const auto together = both.reconstruct(network_options());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_LT(largest_error_m(together[i], segment_of(alone[i])), kSecondOrder_m);
  }
}

}  // namespace
}  // namespace ridgeline::reconstruct
