// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/chio_wang2000/edge_chain.h"

#include "tests/reconstruct/match/ok2011/stereo_pair.h"
#include "tests/support/random.h"

#include <gmock/gmock.h>

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr double kExact = 1e-6;  // rounding of intersections 800 m below the cameras
constexpr double kChainGsd_m = 0.08;

/// What edge_points() would find of a perfect edge.
std::vector<SearchedPoint> perfect_points(const StereoSearch& search, const Segment2& s) {
  std::vector<SearchedPoint> points;
  const int n = static_cast<int>(length(s));
  for (int step = 0; step < n; ++step) {
    const double t = (step + 0.5) / n;
    const Eigen::Vector2d x = (1.0 - t) * s.start + t * s.end;
    points.push_back({{step, x}, search.right_from_left.stretch(x)});
  }
  return points;
}

class Chain : public testing::Test {
 protected:
  [[nodiscard]] EdgeChain chain_of(const Segment3& in_left,
                                   const Segment3& in_right,
                                   double gsd_m = kChainGsd_m) const {
    const EdgeSegment left = test::edge(project(pair.left, in_left));
    const EdgeSegment right = test::edge(project(pair.right, in_right));
    return edge_chain(search.right_from_left, perfect_points(search, left.line.segment), left.line,
                      right.line, gsd_m);
  }

  test::StereoPair pair{0.2};
  StereoSearch search = pair.search();
};

TEST_F(Chain, OfASlopedEdgeHasItsRateAzimuthAndHeight) {
  // 3 m east, 4 m north, 2 m up: run 5 m, rate 0.4, azimuth atan2(3, 4), heights 6 to 8 m
  const Segment3 edge{{10.0, -5.0, 6.0}, {13.0, -1.0, 8.0}};
  const EdgeChain chain = chain_of(edge, edge);
  const ChainSummary& summary = chain.summary;
  EXPECT_EQ(chain.pieces.size() + 1, chain.points.size());
  EXPECT_EQ(summary.n_reliable, static_cast<int>(chain.pieces.size()));
  EXPECT_NEAR(summary.mean_rate, 0.4, kExact);
  EXPECT_NEAR(summary.rate_sigma, 0.0, kExact);
  EXPECT_NEAR(summary.azimuth_rad, std::atan2(3.0, 4.0), kExact);
  // pixels are evenly spaced in the image, hence not quite on the edge, which comes nearer
  EXPECT_NEAR(summary.mean_height_m, 7.0, 0.01);
  const Eigen::Vector3d u = (edge.end - edge.start).normalized();
  for (const ChainPoint& p : chain.points) {
    EXPECT_NEAR((p.x_in_local - edge.start).cross(u).norm(), 0.0, kExact);
  }
}

TEST_F(Chain, RunsTheWayOfTheLeftSegment) {
  const Segment3 edge{{10.0, -5.0, 6.0}, {13.0, -1.0, 8.0}};
  const Segment3 back{edge.end, edge.start};
  EXPECT_NEAR(chain_of(back, edge).summary.mean_rate, -0.4, kExact);
  EXPECT_NEAR(chain_of(back, edge).summary.azimuth_rad, std::atan2(-3.0, -4.0), kExact);
  EXPECT_NEAR(chain_of(edge, back).summary.mean_rate, 0.4, kExact);
}

TEST_F(Chain, EndsWithTheRightSegment) {
  const Segment3 edge{{0.0, 0.0, 6.0}, {2.0, 8.0, 6.0}};
  const Segment3 half{edge.start, midpoint(edge)};
  const auto whole = chain_of(edge, edge).points.size();
  const auto part = chain_of(edge, half).points.size();
  EXPECT_NEAR(static_cast<double>(part), 0.5 * static_cast<double>(whole), 2.0);
  const Segment3 beyond{{4.0, 16.0, 6.0}, {6.0, 24.0, 6.0}};
  EXPECT_TRUE(chain_of(edge, beyond).points.empty());
  EXPECT_EQ(chain_of(edge, beyond).summary.n_reliable, 0);
}

TEST_F(Chain, ReliablePiecesAreHalfAGroundPixelLong) {
  const Segment3 edge{{0.0, 0.0, 6.0}, {2.0, 8.0, 6.0}};
  EXPECT_GT(chain_of(edge, edge, 1.8 * kChainGsd_m).summary.n_reliable, 90);  // 103 px
  EXPECT_EQ(chain_of(edge, edge, 2.2 * kChainGsd_m).summary.n_reliable, 0);
}

TEST_F(Chain, AcrossAGapThereIsNoPiece) {
  const Segment3 edge{{0.0, 0.0, 6.0}, {2.0, 8.0, 6.0}};
  const EdgeSegment left = test::edge(project(pair.left, edge));
  const EdgeSegment right = test::edge(project(pair.right, edge));
  std::vector<SearchedPoint> points = perfect_points(search, left.line.segment);
  points.erase(points.begin() + 10);
  const EdgeChain chain =
      edge_chain(search.right_from_left, points, left.line, right.line, kChainGsd_m);
  EXPECT_EQ(chain.pieces.size() + 2, chain.points.size());
}

TEST_F(Chain, HeightSigmaIsThatOfManyDisturbedSegments) {
  const Segment3 edge{{0.0, 0.0, 6.0}, {3.0, 8.0, 7.0}};
  const EdgeSegment left = test::edge(project(pair.left, edge));
  const EdgeSegment right = test::edge(project(pair.right, edge));
  const double expected = chain_of(edge, edge).summary.height_sigma_m;
  test::Random random(1);
  constexpr int kTrials = 2000;
  double squares = 0.0;
  const auto shifted = [&](const EdgeSegment& s) {
    const Eigen::Vector2d u = (s.line.segment.end - s.line.segment.start).normalized();
    const Eigen::Vector2d move = random.normal(s.line.sigma_q_px) * Eigen::Vector2d(-u.y(), u.x());
    UncertainSegment2 line = s.line;
    line.segment = {line.segment.start + move, line.segment.end + move};
    return line;
  };
  for (int trial = 0; trial < kTrials; ++trial) {
    const UncertainSegment2 a = shifted(left);
    const EdgeChain chain = edge_chain(search.right_from_left, perfect_points(search, a.segment), a,
                                       shifted(right), kChainGsd_m);
    squares += std::pow(chain.summary.mean_height_m - 6.5, 2);
  }
  // the standard deviation of 2000 trials is known to 1.6 %: four of these
  EXPECT_NEAR(std::sqrt(squares / kTrials) / expected, 1.0, 0.065);
}

TEST_F(Chain, ExpectedRateNoiseIsThatOfDisturbedPixels) {
  const Segment3 edge{{0.0, 0.0, 6.0}, {3.0, 8.0, 7.0}};
  const EdgeSegment left = test::edge(project(pair.left, edge));
  const EdgeSegment right = test::edge(project(pair.right, edge));
  constexpr double kEdgeSigma_px = 0.1;
  test::Random random(1);
  double sum = 0.0;
  constexpr int kTrials = 100;
  ChainSummary last;
  for (int trial = 0; trial < kTrials; ++trial) {
    const Eigen::Vector2d u = (left.line.segment.end - left.line.segment.start).normalized();
    std::vector<SearchedPoint> points = perfect_points(search, left.line.segment);
    for (SearchedPoint& p : points) {
      p.point.x_px += random.normal(kEdgeSigma_px) * Eigen::Vector2d(-u.y(), u.x());
      p.stretch = search.right_from_left.stretch(p.point.x_px);
    }
    last = edge_chain(search.right_from_left, points, left.line, right.line, kChainGsd_m).summary;
    sum += last.rate_sigma / kTrials;
  }
  // pieces are a pixel long, a ground pixel within the height of the edge and its perspective
  EXPECT_NEAR(sum / expected_rate_sigma(last, kChainGsd_m, kEdgeSigma_px), 1.0, 0.05);
}

}  // namespace
}  // namespace ridgeline::reconstruct
