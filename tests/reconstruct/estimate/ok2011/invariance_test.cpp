// SPDX-License-Identifier: BSD-3-Clause
// What must not change the lines: scales and signs of cameras, the object frame, orders, threads.
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "tests/reconstruct/support/line_geometry.h"
#include "tests/reconstruct/support/line_group.h"
#include "tests/support/random.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

using test::covariance_of;
using test::kDegree;
using test::LineGroup;
using test::right_segment_of;
using test::segment_of;

constexpr double kTolM = 1e-6;
constexpr double kRelativeTol = 1e-5;  // relative error of covariances

/// Lines of all classes with two or three neighbours each, observed with errors.
LineGroup make_roof(std::uint64_t seed, int num_lines = 12) {
  test::Random random(seed);
  LineGroup group;
  for (int i = 0; i < num_lines; ++i) {
    const Eigen::Vector2d shift(random.uniform(-300, 300), random.uniform(-300, 300));
    const double theta_deg = i % 3 == 0 ? random.uniform(15, 90) : random.uniform(2, 9);
    const int line = static_cast<int>(group.truth.size());
    group.truth.push_back(test::make_segment(
        group.scene,
        {group.scene.left_centre() + shift, theta_deg * kDegree, 100, random.uniform(0, 8), 5}));
    for (const double parameter : {0.1, 0.5, 0.9}) {
      if (parameter == 0.5 && i % 2 == 0) continue;
      group.connections.push_back({line, static_cast<int>(group.truth.size())});
      group.truth.push_back(test::make_neighbour(
          group.scene, group.truth[static_cast<std::size_t>(line)],
          {parameter, random.uniform(40, 140), random.uniform(-4, 4), random.uniform(0, 10)}));
    }
  }
  observe(group, {}, &random);
  return group;
}

void expect_near(const ReconstructedLine& a, const ReconstructedLine& b) {
  EXPECT_STREQ(status_name(a), status_name(b));
  EXPECT_EQ(a.line_class, b.line_class);
  EXPECT_EQ(a.points.size(), b.points.size());
  ASSERT_EQ(a.segment_in_local.has_value(), b.segment_in_local.has_value());
  ASSERT_EQ(a.covariance_m2.has_value(), b.covariance_m2.has_value());
  if (!b.covariance_m2) return;
  EXPECT_LT((segment_of(a).start - segment_of(b).start).norm(), kTolM);
  EXPECT_LT((segment_of(a).end - segment_of(b).end).norm(), kTolM);
  EXPECT_LT((covariance_of(a) - covariance_of(b)).norm(), kRelativeTol * covariance_of(b).norm());
}

void expect_equal(const ReconstructedLine& a, const ReconstructedLine& b) {
  EXPECT_STREQ(status_name(a), status_name(b));
  EXPECT_EQ(a.omega, b.omega);
  ASSERT_EQ(a.segment_in_local.has_value(), b.segment_in_local.has_value());
  ASSERT_EQ(a.covariance_m2.has_value(), b.covariance_m2.has_value());
  if (!b.covariance_m2) return;
  EXPECT_EQ(segment_of(a).start, segment_of(b).start);
  EXPECT_EQ(segment_of(a).end, segment_of(b).end);
  EXPECT_EQ(covariance_of(a), covariance_of(b));
}

/// Expects as many lines in both, most of them with a geometry.
void expect_as_many(const std::vector<ReconstructedLine>& a,
                    const std::vector<ReconstructedLine>& b) {
  ASSERT_EQ(a.size(), b.size());
  const auto n = std::count_if(
      b.begin(), b.end(), [](const ReconstructedLine& l) { return l.covariance_m2.has_value(); });
  EXPECT_GT(2 * n, static_cast<std::ptrdiff_t>(b.size()));
}

/// A method, as published or with the extensions.
struct Path {
  Method method;
  bool is_published;
};

class InvarianceOfEveryPath : public testing::TestWithParam<Path> {
 protected:
  static EstimationOptions options() {
    EstimationOptions options = GetParam().is_published ? test::published() : EstimationOptions{};
    options.lines.method = GetParam().method;
    return options;
  }
};

class Invariance : public testing::TestWithParam<Method> {
 protected:
  static EstimationOptions options() {
    EstimationOptions options = test::published();
    options.lines.method = GetParam();
    return options;
  }
};

TEST_P(Invariance, OfScaleAndSignOfTheCameras) {
  const LineGroup group = make_roof(141);
  LineGroup scaled = group;
  scaled.scene.cameras[0] *= -3.7;
  scaled.scene.cameras[1] *= 1e-4;
  const auto expected = group.reconstruct(options());
  const auto actual = scaled.reconstruct(options());
  for (std::size_t i = 0; i < expected.size(); ++i) expect_near(actual[i], expected[i]);
}

TEST_P(InvarianceOfEveryPath, OfMapCoordinates) {
  const Eigen::Vector3d origin(512000, 5403000, 250);
  const LineGroup group = make_roof(142);
  LineGroup moved = group;
  for (ProjectionMatrix& p : moved.scene.cameras) p.col(3) -= p.leftCols<3>() * origin;
  const auto expected = group.reconstruct(options());
  auto actual = moved.reconstruct(options());
  expect_as_many(actual, expected);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (auto& segment = actual[i].segment_in_local) {
      segment = {segment->start - origin, segment->end - origin};
    }
    expect_near(actual[i], expected[i]);
  }
}

TEST_P(Invariance, OfRotationOfTheObjectFrame) {
  const Eigen::Matrix3d b_from_a =
      (Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, -1).normalized())).toRotationMatrix();
  const LineGroup group = make_roof(143);
  LineGroup rotated = group;
  for (ProjectionMatrix& p : rotated.scene.cameras) {
    p.leftCols<3>() = (p.leftCols<3>() * b_from_a.transpose()).eval();
  }
  const auto expected = group.reconstruct(options());
  auto actual = rotated.reconstruct(options());
  Matrix6d back = Matrix6d::Zero();
  back.topLeftCorner<3, 3>() = b_from_a.transpose();
  back.bottomRightCorner<3, 3>() = b_from_a.transpose();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    Segment3& s = actual[i].segment_in_local.value();
    s = {b_from_a.transpose() * s.start, b_from_a.transpose() * s.end};
    actual[i].covariance_m2 = back * covariance_of(actual[i]) * back.transpose();
    expect_near(actual[i], expected[i]);
  }
}

TEST_P(Invariance, OfTheUnitOfTheObjectFrame) {
  constexpr double kFeet = 3.280839895;
  const LineGroup group = make_roof(144);
  LineGroup in_feet = group;
  for (ProjectionMatrix& p : in_feet.scene.cameras) p.leftCols<3>() /= kFeet;
  EstimationOptions in_unit = options();
  in_unit.building.sigma_meeting_m *= kFeet;
  in_unit.building.max_miss_m *= kFeet;
  const auto expected = group.reconstruct(options());
  auto actual = in_feet.reconstruct(in_unit);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    Segment3& s = actual[i].segment_in_local.value();
    s = {s.start / kFeet, s.end / kFeet};
    actual[i].covariance_m2.value() /= kFeet * kFeet;
    expect_near(actual[i], expected[i]);
  }
}

TEST_P(InvarianceOfEveryPath, OfTheDirectionOfSegments) {
  const LineGroup group = make_roof(145);
  LineGroup turned = group;
  for (UncertainSegment2& s : turned.segments[0]) std::swap(s.segment.start, s.segment.end);
  const auto expected = group.reconstruct(options());
  auto actual = turned.reconstruct(options());
  expect_as_many(actual, expected);
  // parts of a match come in the order of its left segment
  for (auto first = actual.begin(); first != actual.end();) {
    const auto last = std::find_if(first, actual.end(), [&](const ReconstructedLine& line) {
      return line.base().segment != first->base().segment;
    });
    std::reverse(first, last);
    first = last;
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_STREQ(status_name(actual[i]), status_name(expected[i]));
    ASSERT_EQ(actual[i].segment_in_local.has_value(), expected[i].segment_in_local.has_value());
    if (!expected[i].segment_in_local) continue;
    EXPECT_LT((segment_of(actual[i]).start - segment_of(expected[i]).end).norm(), kTolM);
    EXPECT_LT((segment_of(actual[i]).end - segment_of(expected[i]).start).norm(), kTolM);
  }
}

TEST_P(Invariance, OfTheOrderOfImages) {
  const LineGroup group = make_roof(146);
  LineGroup swapped = group;
  std::swap(swapped.scene.cameras[0], swapped.scene.cameras[1]);
  std::swap(swapped.segments[0], swapped.segments[1]);
  const auto expected = group.reconstruct(options());
  const auto actual = swapped.reconstruct(options());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    // the base image decides the regions, hence perhaps the points; the planes are the same
    if (expected[i].determination != Determination::kNetwork &&
        expected[i].line_class == LineClass::kAligned) {
      continue;
    }
    EXPECT_LT((segment_of(actual[i]).start - right_segment_of(expected[i]).start).norm(), kTolM);
    EXPECT_LT((segment_of(actual[i]).end - right_segment_of(expected[i]).end).norm(), kTolM);
  }
}

TEST_P(Invariance, OfTheOrderOfMatches) {
  const LineGroup group = make_roof(147);
  LineGroup reversed = group;
  const int last = static_cast<int>(group.matches.size()) - 1;
  std::reverse(reversed.matches.begin(), reversed.matches.end());
  for (PairConnection& c : reversed.connections) c = {last - c.i, last - c.k};
  const auto expected = group.reconstruct(options());
  auto actual = reversed.reconstruct(options());
  std::reverse(actual.begin(), actual.end());
  for (std::size_t i = 0; i < expected.size(); ++i) expect_near(actual[i], expected[i]);
}

TEST_P(InvarianceOfEveryPath, OfOrderDirectionAndRepetitionOfConnections) {
  const LineGroup group = make_roof(148);
  LineGroup shuffled = group;
  std::reverse(shuffled.connections.begin(), shuffled.connections.end());
  for (PairConnection& c : shuffled.connections) std::swap(c.i, c.k);
  shuffled.connections.insert(shuffled.connections.end(), group.connections.begin(),
                              group.connections.end());
  const auto expected = group.reconstruct(options());
  const auto actual = shuffled.reconstruct(options());
  expect_as_many(actual, expected);
  for (std::size_t i = 0; i < expected.size(); ++i) expect_equal(actual[i], expected[i]);
}

TEST_P(InvarianceOfEveryPath, OfTheNumberOfThreadsToTheLastBit) {
  const LineGroup group = make_roof(149, 60);
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return group.reconstruct(options());
  };
  const auto expected = with_threads(1);
  const auto actual = with_threads(4);
  expect_as_many(actual, expected);
  for (std::size_t i = 0; i < expected.size(); ++i) expect_equal(actual[i], expected[i]);
}

INSTANTIATE_TEST_SUITE_P(Methods,
                         Invariance,
                         testing::Values(Method::kJoint, Method::kNetwork),
                         [](const testing::TestParamInfo<Method>& method) {
                           return std::string(name(method.param));
                         });

INSTANTIATE_TEST_SUITE_P(Methods,
                         InvarianceOfEveryPath,
                         testing::Values(Path{Method::kJoint, true},
                                         Path{Method::kNetwork, true},
                                         Path{Method::kJoint, false},
                                         Path{Method::kNetwork, false}),
                         [](const testing::TestParamInfo<Path>& path) {
                           return std::string(name(path.param.method)) +
                                  (path.param.is_published ? "_published" : "_ours");
                         });

}  // namespace
}  // namespace ridgeline::reconstruct
