// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/match/beyond/guided_matches/step_along.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ridgeline::reconstruct {
namespace {

constexpr int kStepSize_px = 160;
const Segment2 kLine{{40.0, 50.0}, {110.0, 90.0}};

/// A step beside kLine, blurred as by a lens.
struct ImageStep {
  double offset_px, height;
};

cv::Mat image_of(const std::vector<ImageStep>& steps, double noise = 0.0, unsigned seed = 1) {
  constexpr double kBlur_px = 0.7;
  test::Random random(seed);
  cv::Mat image(kStepSize_px, kStepSize_px, CV_32F);
  for (int row = 0; row < kStepSize_px; ++row) {
    for (int column = 0; column < kStepSize_px; ++column) {
      double grey = 0.3 + random.normal(1.0) * noise;
      for (const ImageStep& step : steps) {
        const double beside_px =
            normal(kLine).dot(Eigen::Vector2d(column, row) - kLine.start) - step.offset_px;
        grey += 0.5 * step.height * (1.0 + std::erf(beside_px / (std::sqrt(2.0) * kBlur_px)));
      }
      image.at<float>(row, column) = static_cast<float>(grey);
    }
  }
  return image;
}

/// Mean distance of the samples beside kLine; not a number without a trace.
double found_at_px(const cv::Mat& image, const Segment2& expected = kLine) {
  const auto trace = step_along(ImageSampler(image), expected);
  if (!trace) return std::numeric_limits<double>::quiet_NaN();
  double sum_px = 0.0;
  for (const EdgeSample& s : *trace) sum_px += normal(kLine).dot(s.position_px - kLine.start);
  return sum_px / static_cast<double>(trace->size());
}

constexpr double kFine_px = 0.02;  // bilinear sampling

TEST(StepAlong, IsWhereTheStepIs) {
  for (const double offset_px : {-0.6, 0.0, 0.35}) {
    EXPECT_NEAR(found_at_px(image_of({{offset_px, 0.2}})), offset_px, kFine_px);
  }
}

TEST(StepAlong, FollowsAStepThatIsTurnedAgainstTheExpectedLine) {
  const Eigen::Vector2d aside = 0.5 * normal(kLine);
  const Segment2 turned{kLine.start - aside, kLine.end + aside};
  const cv::Mat image = image_of({{0.0, 0.2}});
  const auto trace = step_along(ImageSampler(image), turned);
  ASSERT_TRUE(trace);
  for (const EdgeSample& s : *trace)
    EXPECT_NEAR(normal(kLine).dot(s.position_px - kLine.start), 0.0, 2.0 * kFine_px);
}

TEST(StepAlong, IsTheExpectedOneBesideAStrongerOne) {
  constexpr double kDrawn_px = 0.7;  // the strong step, whose blur reaches this far, draws it
  for (const double side : {1.0, -1.0}) {
    const Eigen::Vector2d aside = 0.4 * side * normal(kLine);  // the stronger step is at 1.85 px
    EXPECT_NEAR(found_at_px(image_of({{0.0, 0.04}, {2.25 * side, -0.2}}, 0.005),
                            {kLine.start + aside, kLine.end + aside}),
                0.0, kDrawn_px);
  }
}

TEST(StepAlong, SeesWhatIsTooFaintForSinglePixels) {
  constexpr double kNoise = 0.02;
  constexpr double kScatter_px = 0.5;
  int n_found = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const double at_px = found_at_px(image_of({{0.0, kNoise}}, kNoise, seed));
    if (std::abs(at_px) < kScatter_px) ++n_found;
  }
  EXPECT_GE(n_found, 15);  // three of four are seen in noise as strong as the step
}

TEST(StepAlong, IsRareInNoise) {
  int n_found = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    if (!std::isnan(found_at_px(image_of({}, 0.02, seed)))) ++n_found;
  }
  EXPECT_LE(n_found, 5);
}

TEST(StepAlong, NeedsTheImageAndALengthOf10px) {
  const cv::Mat image = image_of({{0.0, 0.2}});
  const Eigen::Vector2d far(500.0, 0.0);
  EXPECT_TRUE(std::isnan(found_at_px(image, {kLine.start + far, kLine.end + far})));
  EXPECT_TRUE(std::isnan(found_at_px(image, {kLine.start, kLine.start + 8.0 * along(kLine)})));
  EXPECT_TRUE(std::isnan(found_at_px(image_of({}))));
}

}  // namespace
}  // namespace ridgeline::reconstruct
