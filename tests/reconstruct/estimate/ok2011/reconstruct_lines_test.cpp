// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"

#include "tests/reconstruct/support/line_geometry.h"
#include "tests/reconstruct/support/line_group.h"
#include "tests/support/random.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

using test::covariance_of;
using test::direct_options;
using test::kDegree;
using test::kThreeNeighbours;
using test::line_at;
using test::LineGroup;
using test::make_group;
using test::NeighbourSpec;
using test::right_segment_of;
using test::segment_of;
using test::SegmentSpec;

constexpr double kRecoveredM = 1e-6;
constexpr double kRecoveredPx = 1e-8;

const test::StereoScene kScene;

double error_m(const ReconstructedLine& line, const Segment3& truth) {
  return std::max((segment_of(line).start - truth.start).norm(),
                  (segment_of(line).end - truth.end).norm());
}

TEST(ReconstructLines, DirectRecoversLinesWithoutNoise) {
  for (const double theta_deg : {90.0, 45.0, 10.0, 5.0, 1.0, 0.1}) {
    const LineGroup group = make_group(line_at(theta_deg), {});
    const ReconstructedLine line = group.reconstruct(direct_options())[0];
    ASSERT_STREQ(status_name(line), "direct") << theta_deg;
    EXPECT_LT(error_m(line, group.truth[0]), kRecoveredM) << theta_deg;
    const auto truth = group.scene.images(group.truth[0]);
    for (std::size_t j = 0; j < 2; ++j) {
      const Segment2 image = project(group.scene.cameras[j], segment_of(line));
      EXPECT_LT((image.start - truth[j].start).norm(), kRecoveredPx) << theta_deg;
      EXPECT_LT((image.end - truth[j].end).norm(), kRecoveredPx) << theta_deg;
    }
  }
}

TEST(ReconstructLines, JointRecoversAlignedLinesWithoutNoise) {
  for (const double theta_deg : {9.0, 3.0, 0.5, 0.0}) {
    const LineGroup group =
        make_group(line_at(theta_deg), {kThreeNeighbours[0], kThreeNeighbours[2]});
    const ReconstructedLine line = group.reconstruct()[0];
    ASSERT_STREQ(status_name(line), "joint") << theta_deg;
    EXPECT_LT(error_m(line, group.truth[0]), kRecoveredM) << theta_deg;
    EXPECT_LT((right_segment_of(line).end - group.truth[0].end).norm(), kRecoveredM);
    EXPECT_LT(line.omega, 1e-6);
  }
}

TEST(ReconstructLines, LabelsTheClassByTheSmallerAngle) {
  for (const auto& [theta_deg, expected] :
       {std::pair(8.0, LineClass::kAligned), std::pair(0.0, LineClass::kAligned),
        std::pair(14.0, LineClass::kNotAligned), std::pair(-40.0, LineClass::kNotAligned)}) {
    const ReconstructedLine line = make_group(line_at(theta_deg), {}).reconstruct()[0];
    EXPECT_EQ(line.line_class, expected) << theta_deg;
    EXPECT_LE(line.epipolar_angle_rad, std::abs(theta_deg) * kDegree + 1e-8);
  }
}

TEST(ReconstructLines, TheThresholdAngleIsStillAligned) {
  LineGroup group = make_group(line_at(20.0), kThreeNeighbours);
  EstimationOptions options = test::published();
  const double angle_rad = group.reconstruct(options)[0].epipolar_angle_rad;
  options.lines.max_aligned_angle_deg = angle_rad * 180.0 / std::numbers::pi;
  EXPECT_EQ(group.reconstruct(options)[0].line_class, LineClass::kAligned);
  options.lines.max_aligned_angle_deg = std::nextafter(options.lines.max_aligned_angle_deg, 0.0);
  EXPECT_EQ(group.reconstruct(options)[0].line_class, LineClass::kNotAligned);
}

TEST(ReconstructLines, ALongSegmentIsNotCarriedOnFarBeyondAShortCounterpart) {
  constexpr double kShare = 0.12;  // share of the line that the right image shows
  LineGroup group = make_group(line_at(40.0), {});
  UncertainSegment2& right = group.segments[1][0];
  const Segment2 whole = right.segment;
  const test::Noise noise;
  // the direction of n edge pixels is as uncertain as n^-1.5
  right = test::exact({whole.start, whole.start + kShare * (whole.end - whole.start)},
                      {noise.q_px, noise.phi_rad / std::pow(kShare, 1.5), noise.e_px});
  const double seen_m = kShare * length(group.truth[0]);
  const ReconstructedLine line = group.reconstruct(EstimationOptions{})[0];
  EXPECT_STREQ(status_name(line), "direct");
  EXPECT_NEAR(length(segment_of(line)), seen_m, 0.1);  // the scale along the line changes
  EXPECT_LT((segment_of(line).start - group.truth[0].start).norm(), kRecoveredM);

  const ReconstructedLine published = group.reconstruct(direct_options())[0];
  EXPECT_NEAR(length(segment_of(published)), length(group.truth[0]), kRecoveredM);
  EXPECT_LT(*line.direct_sigma_z_m, 0.3 * *published.direct_sigma_z_m);
}

TEST(ReconstructLines, OfALineWithTwoCounterpartsEachGivesThePartThatItsCounterpartShows) {
  LineGroup group = make_group(line_at(60.0), {});
  const Segment3 whole = group.truth[0];
  const std::array<Segment3, 2> parts{Segment3{whole.start, point_at(whole, 0.4)},
                                      Segment3{point_at(whole, 0.6), whole.end}};
  group.segments[1].clear();
  for (const Segment3& part : parts) {
    group.segments[1].push_back(test::exact(group.scene.images(part)[1], test::Noise{}));
  }
  group.matches = {{0, 0}, {0, 1}};
  const std::vector<ReconstructedLine> lines = group.reconstruct(direct_options());
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(error_m(lines[i], parts[i]), kRecoveredM) << i;
    const Segment2 seen = group.scene.images(parts[i])[0];
    EXPECT_LT((lines[i].base().px.start - seen.start).norm(), 1e-6) << i;
  }
}

TEST(ReconstructLines, JointLeavesNotAlignedLinesBitwiseAsDirect) {
  test::Random random(131);
  for (int trial = 0; trial < 50; ++trial) {
    const LineGroup group =
        make_group(line_at(random.uniform(15, 90)), kThreeNeighbours, {}, &random);
    const ReconstructedLine direct = group.reconstruct(direct_options())[0];
    const ReconstructedLine joint = group.reconstruct()[0];
    EXPECT_STREQ(status_name(joint), "direct");
    EXPECT_EQ(segment_of(joint).start, segment_of(direct).start);
    EXPECT_EQ(segment_of(joint).end, segment_of(direct).end);
    EXPECT_EQ(covariance_of(joint), covariance_of(direct));
    EXPECT_TRUE(joint.points.empty());
  }
}

TEST(ReconstructLines, JointWithoutPointsIsDirect) {
  test::Random random(132);
  const LineGroup group = make_group(line_at(5.0), {}, {}, &random);
  const ReconstructedLine direct = group.reconstruct(direct_options())[0];
  const ReconstructedLine joint = group.reconstruct()[0];
  EXPECT_STREQ(status_name(joint), "no_points");
  EXPECT_EQ(segment_of(joint).start, segment_of(direct).start);
  EXPECT_EQ(covariance_of(joint), covariance_of(direct));
}

TEST(ReconstructLines, StatusTellsTheNumberOfPoints) {
  std::vector<NeighbourSpec> neighbours;
  const std::array expected{"no_points", "one_point", "joint", "joint"};
  for (std::size_t n = 0; n <= 3; ++n) {
    const ReconstructedLine line = make_group(line_at(4.0), neighbours).reconstruct()[0];
    EXPECT_STREQ(status_name(line), expected[n]);
    EXPECT_EQ(line.points.size(), n);
    if (n < 3) neighbours.push_back(kThreeNeighbours[n]);
  }
}

TEST(ReconstructLines, ExactlyAlignedWithOnePointIsRankDeficientAndHasNoCovariance) {
  const LineGroup group = make_group(line_at(0.0), {kThreeNeighbours[0]});
  const ReconstructedLine line = group.reconstruct()[0];
  EXPECT_STREQ(status_name(line), "rank_deficient");
  EXPECT_FALSE(line.covariance_m2);
  EXPECT_STREQ(status_name(group.reconstruct(direct_options())[0]), "no_intersection");
  EXPECT_FALSE(group.reconstruct(direct_options())[0].segment_in_local);
}

TEST(ReconstructLines, UsedPointsAreOnTheLineWithTheirRegionAndNeighbour) {
  const LineGroup group = make_group(line_at(4.0), kThreeNeighbours);
  const std::vector<UsedPoint> points = group.reconstruct()[0].points;
  ASSERT_EQ(points.size(), 3);
  for (int i = 0; i < 3; ++i) {
    const UsedPoint& point = points[static_cast<std::size_t>(i)];
    EXPECT_EQ(point.neighbour, i + 1);
    EXPECT_EQ(point.region, static_cast<Region>(i));
    EXPECT_GT(point.weight, 0.9);
    EXPECT_LT(point.omega, 1e-9);
    EXPECT_LT(distance(group.truth[0], point.x_in_local), kRecoveredM);
    const Eigen::Vector3d eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(point.cov_m2).eigenvalues();
    EXPECT_GT(eigenvalues(0), 0.0);
    EXPECT_LT(std::sqrt(eigenvalues(2)), 1.0);
  }
}

TEST(ReconstructLines, WeighsPointsByTheMeasuresOfBothImages) {
  constexpr double kTol = 1e-6;
  LineGroup group = make_group(line_at(8.0), {{0.5, 70, 3, 10}});
  for (Eigen::Vector2d* x : {&group.segments[1][1].segment.start, &group.segments[1][1].segment.end,
                             &group.segments[1][1].centroid_px}) {
    x->x() += 10.0;  // off the epipolar line by 10 px times the sine of the line's angle
  }
  // the expected values follow from pixel coordinates
  std::array<Eigen::Vector3d, 2> crossing;
  std::array<double, 2> distance_px{};
  for (std::size_t j = 0; j < 2; ++j) {
    const Segment2& a = group.segments[j][0].segment;
    const Segment2& b = group.segments[j][1].segment;
    crossing[j] = a.start.homogeneous()
                      .cross(a.end.homogeneous())
                      .cross(b.start.homogeneous().cross(b.end.homogeneous()));
    crossing[j] /= crossing[j].z();
    distance_px[j] = distance(a, b);
  }
  const Eigen::Matrix3d f = fundamental_matrix(group.scene.cameras[0], group.scene.cameras[1]);
  const Eigen::Vector3d in_left = f.transpose() * crossing[1];
  const Eigen::Vector3d in_right = f * crossing[0];
  const std::array<double, 2> epipolar_px{
      std::abs(in_left.dot(crossing[0])) / in_left.head<2>().norm(),
      std::abs(in_right.dot(crossing[1])) / in_right.head<2>().norm()};
  ASSERT_GT(epipolar_px[0], 0.5);

  EstimationOptions options = test::published();
  EXPECT_NEAR(group.reconstruct(options)[0].points.at(0).weight,
              std::exp(-std::min(distance_px[0], distance_px[1]) / 10.0 -
                       std::min(epipolar_px[0], epipolar_px[1]) / 4.0),
              kTol);
}

TEST(ReconstructLines, DiscardsPointsOutsideTheRangeOfHeights) {
  LineGroup group = make_group(line_at(4.0), kThreeNeighbours);  // heights 3 to 4 m
  group.height_range_in_local_m[0] = 3.3;
  EXPECT_EQ(group.reconstruct()[0].points.size(), 2);
  group.height_range_in_local_m[1] = 3.7;
  EXPECT_EQ(group.reconstruct()[0].points.size(), 1);
}

TEST(ReconstructLines, AnswersInOrderOfTheTracksAndForNoneWithNone) {
  LineGroup group = make_group(line_at(4.0), kThreeNeighbours);
  const auto lines = group.reconstruct();
  ASSERT_EQ(lines.size(), group.matches.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].base().segment, static_cast<int>(i));
  }
  group.matches.clear();
  group.connections.clear();
  EXPECT_TRUE(group.reconstruct().empty());
}

TEST(ReconstructLines, MovesSegmentsAsAsked) {
  constexpr double kShiftPx = 1.5;
  for (const Method method : {Method::kDirect, Method::kJoint, Method::kNetwork}) {
    EstimationOptions options = direct_options();
    options.lines.method = method;
    const LineGroup good = make_group(line_at(40.0), kThreeNeighbours);
    LineGroup group = good;
    UncertainSegment2& moved = group.segments[1][0];
    const Eigen::Vector2d u = (moved.segment.end - moved.segment.start).normalized();
    const Eigen::Vector2d by = -kShiftPx * Eigen::Vector2d(-u.y(), u.x());
    for (Eigen::Vector2d* x : {&moved.segment.start, &moved.segment.end, &moved.centroid_px})
      *x += by;
    std::vector<Registrations> registrations(4, Registrations(2));
    registrations[0][1].shift_px = kShiftPx;
    const ReconstructedLine truth = good.reconstruct(options)[0];
    EXPECT_GT(error_m(group.reconstruct(options)[0], segment_of(truth)), 0.1);
    const ReconstructedLine line = group.reconstruct(options, registrations)[0];
    EXPECT_LT(error_m(line, segment_of(truth)), kRecoveredM) << name(method);
    EXPECT_LT((line.other().px.start - good.segments[1][0].segment.start).norm(), kRecoveredPx);
    EXPECT_LT((covariance_of(line) - covariance_of(truth)).norm(),
              kRecoveredM * covariance_of(truth).norm());
  }
}

TEST(ReconstructLines, SigmaScaleMultipliesTheErrorsAcrossTheLine) {
  constexpr double kScale = 3.0;
  for (const Method method : {Method::kDirect, Method::kNetwork}) {
    EstimationOptions options = direct_options();
    options.lines.method = method;
    LineGroup group = make_group(line_at(40.0), kThreeNeighbours);
    group.connections.clear();
    const ReconstructedLine plain = group.reconstruct(options)[0];
    const std::vector<Registrations> registrations(4, Registrations(2, {0.0, kScale}));
    const ReconstructedLine scaled = group.reconstruct(options, registrations)[0];
    EXPECT_EQ(segment_of(scaled).start, segment_of(plain).start);
    const Eigen::Vector3d along = (segment_of(plain).end - segment_of(plain).start).normalized();
    Matrix6d across = Matrix6d::Zero();
    across.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() - along * along.transpose();
    across.bottomRightCorner<3, 3>() = across.topLeftCorner<3, 3>();
    const Matrix6d expected = kScale * kScale * across * covariance_of(plain) * across;
    EXPECT_LT((across * covariance_of(scaled) * across - expected).norm(), 1e-6 * expected.norm());
  }
}

TEST(ReconstructLines, AlignedLinesTakeWhatTheyMeetAsItWasExtracted) {
  const LineGroup group = make_group(line_at(4.0), kThreeNeighbours);
  const std::vector<Registrations> registrations{
      {{}, {}}, {{0.0, 2.0}, {1.5, 2.0}}, {{0.0, 0.5}, {-1.5, 0.5}}, {{0.0, 2.0}, {1.5, 2.0}}};
  for (const EstimationOptions& options : {test::published(), EstimationOptions{}}) {
    const std::vector<ReconstructedLine> plain = group.reconstruct(options);
    const std::vector<ReconstructedLine> moved = group.reconstruct(options, registrations);
    ASSERT_TRUE(plain[0].segment_in_local && moved[0].segment_in_local);
    EXPECT_EQ(segment_of(moved[0]).start, segment_of(plain[0]).start);
    EXPECT_EQ(segment_of(moved[0]).end, segment_of(plain[0]).end);
    EXPECT_EQ(covariance_of(moved[0]), covariance_of(plain[0]));
    for (const std::size_t neighbour : {1U, 2U, 3U}) {
      EXPECT_GT(error_m(moved[neighbour], segment_of(plain[neighbour])), 0.1);
    }
  }
}

TEST(ReconstructLines, RejectsWrongInput) {
  const LineGroup good = make_group(line_at(4.0), kThreeNeighbours);
  const auto rejected = [](const LineGroup& group,
                           const EstimationOptions& options = test::published(),
                           const std::vector<Registrations>& registrations = {}) {
    try {
      static_cast<void>(group.reconstruct(options, registrations));
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  LineGroup group = good;
  group.matches[1].other = 4;
  EXPECT_EQ(rejected(group), "track: segment = 4, must be in [0, 4)");
  group = good;
  group.connections[0].k = -1;
  EXPECT_EQ(rejected(group), "connection: k = -1, must be in [0, 4)");
  group = good;
  group.connections[0] = {2, 2};
  EXPECT_EQ(rejected(group), "connection: i = k = 2, must be two tracks");
  group = good;
  group.segments[0][3].sigma_q_px = 0.0;
  EXPECT_EQ(rejected(group), "uncertain_line: sigma_q_px = 0, must be positive");
  group = good;
  group.segments.pop_back();
  EXPECT_EQ(rejected(group), "reconstruct_lines: images = 1, must be one per camera, 2");
  EstimationOptions options = test::published();
  options.lines.max_aligned_angle_deg = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(rejected(good, options), "max_aligned_angle_deg = nan, must be in [0, 90]");
  EXPECT_EQ(rejected(good), "accepted");
  options = test::published();
  for (const Method method : {Method::kPlanes, Method::kLines}) {
    options.lines.method = method;
    EXPECT_EQ(rejected(good, options),
              std::string("reconstruct_lines: method = ") + name(method) +
                  ", whose lines do not only come from tracks; see plane_lines()");
  }
  const auto rejected_registration = [&](const Registration& of_first) {
    std::vector<Registrations> registrations(good.matches.size(), Registrations(2));
    registrations[0][1] = of_first;
    return rejected(good, test::published(), registrations);
  };
  EXPECT_EQ(rejected(good, test::published(), {{{}, {}}}),
            "reconstruct_lines: registrations = 1, must be one per track, 4, or none");
  EXPECT_EQ(rejected(good, test::published(), std::vector<Registrations>(4, Registrations(1))),
            "reconstruct_lines: registrations of a track = 1, must be one per observation, 2");
  EXPECT_EQ(rejected_registration({HUGE_VAL, 1.0}),
            "reconstruct_lines: shift_px = inf, must be finite");
  EXPECT_EQ(rejected_registration({0.0, 0.0}),
            "reconstruct_lines: sigma_scale = 0, must be positive");
  const std::vector<Track> tracks = tracks_of_pair({0, 1}, good.matches);
  EXPECT_THROW(reconstruct_lines({std::span(good.scene.cameras).first(1), good.segments, tracks,
                                  good.connections}),
               std::invalid_argument);
  const std::vector<Track> of_one_view{{{{0, 0}, {0, 1}}}};
  EXPECT_THROW(reconstruct_lines({good.scene.cameras, good.segments, of_one_view, {}}),
               std::invalid_argument);
}

TEST(StatusName, IsTheFailureOrWhetherConfirmedOrTheDetermination) {
  ReconstructedLine line;
  EXPECT_STREQ(status_name(line), "no_intersection");
  line.failure = Failure::kAmbiguousDepth;
  EXPECT_STREQ(status_name(line), "ambiguous_depth");
  line.failure.reset();
  const std::array names{"direct",        "joint",      "one_point", "surface",
                         "segment_ends",  "horizontal", "no_points", "rank_deficient",
                         "not_converged", "network",    "planes"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    line.determination = static_cast<Determination>(i);
    EXPECT_STREQ(status_name(line), names[i]);
  }
  line.confirmed = false;
  EXPECT_STREQ(status_name(line), "unconfirmed");
}

TEST(Names, AreThoseOfTheFiles) {
  EXPECT_STREQ(name(Method::kDirect), "direct");
  EXPECT_STREQ(name(Method::kJoint), "joint");
  EXPECT_STREQ(name(Method::kNetwork), "network");
  EXPECT_STREQ(name(Method::kPlanes), "planes");
  EXPECT_STREQ(name(Method::kLines), "lines");
  EXPECT_STREQ(name(LineClass::kAligned), "aligned");
  EXPECT_STREQ(name(LineClass::kNotAligned), "not_aligned");
}

}  // namespace
}  // namespace ridgeline::reconstruct
