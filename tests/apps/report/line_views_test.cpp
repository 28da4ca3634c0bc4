// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/line_views.h"

#include "tests/support/random.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <vector>

namespace ridgeline::apps {
namespace {

using Covariance = Eigen::Matrix<double, 6, 6>;

constexpr double kHeight_m = 100.0;
constexpr double kFocalLength_px = 1000.0;  // 10 px/m at the height 0
constexpr double kSize_px = 400.0;
constexpr double kTolerance_px = 1e-6;  // of a derivative by differences

/// A camera above the origin that looks straight down, with the origin in the middle of its image.
ProjectionMatrix camera_above() {
  constexpr double kMiddle_px = 0.5 * kSize_px;
  ProjectionMatrix p;
  p << kFocalLength_px, 0.0, -kMiddle_px, kMiddle_px * kHeight_m,  //
      0.0, -kFocalLength_px, -kMiddle_px, kMiddle_px * kHeight_m,  //
      0.0, 0.0, -1.0, kHeight_m;
  return p;
}

/// 100 px long in the middle of the image, along its rows.
const Segment3 kLine{{-5.0, 0.0, 0.0}, {5.0, 0.0, 0.0}};

TEST(OffsetOf, IsTheDistanceAcrossTheProjectionWithItsSigma) {
  const Covariance covariance = 0.01 * Covariance::Identity();  // 0.1 m are 1 px
  const auto offset =
      offset_of(camera_above(), kLine, covariance, {{150.0, 202.0}, {250.0, 202.0}}, nullptr);
  ASSERT_TRUE(offset);
  EXPECT_NEAR(offset->offset_px, 2.0, kTolerance_px);
  EXPECT_NEAR(offset->sigma_px, 1.0, kTolerance_px);
}

TEST(OffsetOf, HasTheUncertaintyOfTheSegmentToo) {
  const Segment2 px{{150.0, 202.0}, {250.0, 202.0}};
  const UncertainSegment2 segment{px, {200.0, 202.0}, 0.3, 0.01, 1.0};
  const auto offset = offset_of(camera_above(), kLine, 0.01 * Covariance::Identity(), px, &segment);
  ASSERT_TRUE(offset);
  // the line, the segment's shift, its direction over 50 px
  EXPECT_NEAR(offset->sigma_px, std::sqrt(1.0 + 0.3 * 0.3 + 0.5 * 0.5), kTolerance_px);
}

TEST(OffsetOf, IsThatOfTheEndThatIsOffByMoreSigmas) {
  Covariance covariance = 0.01 * Covariance::Identity();
  const Segment2 tilted{{150.0, 202.0}, {250.0, 197.0}};
  EXPECT_NEAR(offset_of(camera_above(), kLine, covariance, tilted, nullptr)->offset_px, 3.0,
              kTolerance_px);
  covariance.bottomRightCorner<3, 3>() *=
      100.0;  // 3 px of sigma 10 at the end, 2 of sigma 1 at the start
  EXPECT_NEAR(offset_of(camera_above(), kLine, covariance, tilted, nullptr)->offset_px, 2.0,
              kTolerance_px);
}

TEST(OffsetOf, HasTheSigmaOfLinesThatScatter) {
  constexpr double kSigma_m = 0.02;
  constexpr int kDraws = 4000;  // a sigma is known to 1.1 %
  test::Random random(11);
  const Segment3 line{{-8.0, 3.0, 1.0}, {6.0, 5.0, 9.0}};
  Segment2 px = project(camera_above(), line);
  constexpr double kOffset_px = 0.5;
  px.start += kOffset_px * normal(px);  // so that this end speaks
  const Covariance covariance = kSigma_m * kSigma_m * Covariance::Identity();
  const auto offset = offset_of(camera_above(), line, covariance, px, nullptr);
  ASSERT_TRUE(offset);
  EXPECT_NEAR(offset->offset_px, kOffset_px, kTolerance_px);
  double sum_px2 = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const auto moved = [&](const Eigen::Vector3d& x) -> Eigen::Vector3d {
      const double dx_m = random.normal(kSigma_m);
      const double dy_m = random.normal(kSigma_m);
      return x + Eigen::Vector3d(dx_m, dy_m, random.normal(kSigma_m));
    };
    const Segment3 drawn{moved(line.start), moved(line.end)};
    const Segment2 seen = project(camera_above(), drawn);
    sum_px2 += std::pow(normal(seen).dot(px.start - seen.start) - kOffset_px, 2);
  }
  EXPECT_NEAR(offset->sigma_px / std::sqrt(sum_px2 / kDraws), 1.0, 0.05);
}

TEST(OffsetOf, IsNothingForALineThatIsSeenAsAPoint) {
  const Segment3 plumb{{0.0, 0.0, 0.0}, {0.0, 0.0, 10.0}};
  EXPECT_FALSE(offset_of(camera_above(), plumb, Covariance::Identity(),
                         {{150.0, 202.0}, {250.0, 202.0}}, nullptr));
}

/// Points of a level square around the origin at a height, 0.25 m apart.
std::vector<Eigen::Vector3d> level(double half_m, double z_m) {
  constexpr double kSpacing_m = 0.25;
  std::vector<Eigen::Vector3d> points;
  for (double x = -half_m; x <= half_m; x += kSpacing_m) {
    for (double y = -half_m; y <= half_m; y += kSpacing_m) points.emplace_back(x, y, z_m);
  }
  return points;
}

ViewOfLine unobserved(const Segment3& line, const std::vector<Eigen::Vector3d>& surface) {
  return ImageField(camera_above(), {kSize_px, kSize_px}, surface).unobserved(line);
}

TEST(ImageField, MissesALineThatNothingHides) {
  EXPECT_EQ(unobserved(kLine, {}), ViewOfLine::kMissing);
  EXPECT_EQ(unobserved(kLine, level(20.0, 0.0)), ViewOfLine::kMissing);
}

TEST(ImageField, KnowsThatARoofHidesALine) {
  EXPECT_EQ(unobserved(kLine, level(20.0, 10.0)), ViewOfLine::kHidden);
  // half a metre is an error of the surface
  EXPECT_EQ(unobserved(kLine, level(20.0, 0.5)), ViewOfLine::kMissing);
  // less than half of the line is hidden
  std::vector<Eigen::Vector3d> shed = level(20.0, 0.0);
  for (const Eigen::Vector3d& x : level(1.8, 10.0)) shed.push_back(x);
  EXPECT_EQ(unobserved(kLine, shed), ViewOfLine::kMissing);
  for (const Eigen::Vector3d& x : level(3.0, 10.0)) shed.push_back(x);
  EXPECT_EQ(unobserved(kLine, shed), ViewOfLine::kHidden);
}

TEST(ImageField, ExpectsNothingBeyondItsBorder) {
  EXPECT_EQ(unobserved({{15.0, 0.0, 0.0}, {25.0, 0.0, 0.0}}, {}), ViewOfLine::kBorder);
  EXPECT_EQ(unobserved({{-5.0, 19.8, 0.0}, {5.0, 19.8, 0.0}}, {}), ViewOfLine::kBorder);
  EXPECT_EQ(unobserved({{25.0, 0.0, 0.0}, {35.0, 0.0, 0.0}}, {}), ViewOfLine::kOutside);
}

TEST(ImageField, OfAnImageSaysNothingOfALineThatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(unobserved({{nan, 0.0, 0.0}, {nan, 0.0, 0.0}}, level(20.0, 10.0)),
            ViewOfLine::kOutside);
}

}  // namespace
}  // namespace ridgeline::apps
