// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/extract_segments.h"

#include "reconstruct/scene/normalised_image.h"
#include "tests/reconstruct/extract/ok2011/blurred_scene.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <tbb/global_control.h>

namespace ridgeline::reconstruct {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

std::vector<EdgeSegment> extract(const cv::Mat& raw) {
  return extract_segments(normalised_image(raw));
}

/// A grey image that is white from column `x` on.
cv::Mat white_from_column(int x, int size_px, int type = CV_8UC1) {
  cv::Mat raw(size_px, size_px, type, cv::Scalar::all(80));
  raw.colRange(x, size_px).setTo(cv::Scalar::all(160));
  return raw;
}

TEST(ExtractSegments, AnImageWithoutTextureHasNone) {
  EXPECT_THAT(extract(cv::Mat(300, 300, CV_8UC3, cv::Scalar::all(90))), IsEmpty());
}

TEST(ExtractSegments, NoiseAloneHasAlmostNone) {
  cv::Mat raw(600, 600, CV_8UC3);
  cv::RNG random(8);
  random.fill(raw, cv::RNG::NORMAL, 120.0, 6.0);
  EXPECT_LE(extract(raw).size(), 3U);
}

TEST(ExtractSegments, TakesImagesOfAFewPixels) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(2, 1), cv::Size(1, 40), cv::Size(3, 3)}) {
    cv::Mat raw(size, CV_8UC1, cv::Scalar(7));
    raw.at<std::uint8_t>(0, 0) = 200;
    EXPECT_THAT(extract(raw), IsEmpty()) << size;
  }
}

TEST(ExtractSegments, AStepIsOneSegmentBetweenThePixels) {
  for (const int type : {CV_8UC1, CV_8UC2, CV_8UC3, CV_8UC4, CV_16UC1, CV_16UC4}) {
    const std::vector<EdgeSegment> segments = extract(white_from_column(50, 100, type));
    ASSERT_THAT(segments, SizeIs(1)) << type;
    EXPECT_NEAR(segments[0].line.centroid_px.x(), 49.5, 1e-3);
    EXPECT_GT(length(segments[0].in_image), 90.0);
  }
}

TEST(ExtractSegments, AStepWithoutNoiseIsAsUncertainAsTheSystematicPart) {
  const ExtractOptions options;
  for (const bool in_rows : {false, true}) {
    const cv::Mat raw = white_from_column(50, 100);
    const std::vector<EdgeSegment> segments = extract(in_rows ? cv::Mat(raw.t()) : raw);
    ASSERT_THAT(segments, SizeIs(1));
    const UncertainSegment2& line = segments[0].line;
    EXPECT_NEAR(line.sigma_q_px, options.systematic_across_px, 1e-3);
    EXPECT_GT(line.sigma_phi_rad, 0.0);
    EXPECT_LT(line.sigma_phi_rad, 1e-3);  // 0.02 px at the ends of 100 px
  }
}

TEST(ExtractSegments, TheBrighterSideIsOnTheRight) {
  // x runs right and y down: white lies on the right of a line that runs up
  const std::vector<EdgeSegment> segments = extract(white_from_column(50, 100));
  ASSERT_THAT(segments, SizeIs(1));
  EXPECT_LT(segments[0].in_image.end.y(), segments[0].in_image.start.y());
  EXPECT_LT(segments[0].left.grey, segments[0].right.grey);
  EXPECT_NEAR(segments[0].right.grey, 1.0F, 1e-6F);
}

TEST(ExtractSegments, SixteenBitsOfWhichTwelveAreUsedGiveTheSame) {
  const test::BlurredScene scene = test::blurred_scene(2, {.size_px = 300});
  cv::Mat deep;
  scene.raw.convertTo(deep, CV_16U, 16.0);
  const auto shallow_segments = extract(scene.raw);
  const auto deep_segments = extract(deep);
  ASSERT_EQ(shallow_segments.size(), deep_segments.size());
  for (std::size_t i = 0; i < deep_segments.size(); ++i) {
    const Eigen::Vector2d difference =
        shallow_segments[i].line.centroid_px - deep_segments[i].line.centroid_px;
    EXPECT_LT(difference.norm(), 1e-3);
  }
}

TEST(ExtractSegments, ALongEdgeThatIsCoveredInPlacesIsOneSegment) {
  cv::Mat raw = white_from_column(50, 200);
  for (const int y : {40, 90, 140}) raw(cv::Rect(44, y, 12, 5)).setTo(120);
  cv::GaussianBlur(raw, raw, {5, 5}, 0.8);
  int n_long = 0;
  for (const EdgeSegment& segment : extract(raw))
    n_long += length(segment.in_image) > 150.0 ? 1 : 0;
  EXPECT_EQ(n_long, 1);
}

/// A step that is covered in places and frayed at its end.
cv::Mat frayed_step(int seed) {
  constexpr int kSize_px = 60;
  constexpr int kFrayed_px = 40;  // the edge is frayed from this row on
  cv::RNG random(static_cast<std::uint64_t>(seed));
  cv::Mat raw(kSize_px, kSize_px, CV_8UC1, cv::Scalar(80));
  const double slope = random.uniform(-1.0, 1.0);
  const auto edge_at = [&](int y) { return 0.5 * kSize_px + slope * (y - 0.5 * kSize_px); };
  for (int y = 0; y < kSize_px; ++y) {
    for (int x = 0; x < kSize_px; ++x) {
      const double off = y > kFrayed_px ? random.uniform(-1.0, 1.0) : 0.0;
      if (x > edge_at(y) + off) raw.at<std::uint8_t>(y, x) = 200;
    }
  }
  for (int i = random.uniform(0, 12); i > 0; --i) {
    const int y = random.uniform(2, kSize_px - 5);
    const int x = static_cast<int>(edge_at(y)) - random.uniform(1, 6);
    const int width = random.uniform(2, 12);
    const cv::Rect cover(x, y, width, random.uniform(1, 5));
    raw(cover & cv::Rect({0, 0}, raw.size())).setTo(random.uniform(60, 220));
  }
  return raw;
}

TEST(ExtractSegments, AreLinesThroughThreeEdgePixelsAtLeastHoweverShort) {
  // in these 6 of 4000 images a bend leaves two edge pixels, 3 px apart, beside it
  ExtractOptions options;
  options.min_length_px = 3.0;
  for (const int seed : {829, 978, 989, 1132, 1691, 2106}) {
    EXPECT_NO_THROW(extract_segments(normalised_image(frayed_step(seed)), {}, options)) << seed;
  }
}

TEST(ExtractSegments, DoesNotDependOnTheNumberOfThreads) {
  const cv::Mat image = normalised_image(test::blurred_scene(3).raw);
  const auto serial = [&] {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    return extract_segments(image);
  }();
  const auto parallel = extract_segments(image);
  ASSERT_EQ(serial.size(), parallel.size());
  for (std::size_t i = 0; i < serial.size(); ++i) {
    EXPECT_EQ(serial[i].line.segment.start, parallel[i].line.segment.start);
    EXPECT_EQ(serial[i].line.segment.end, parallel[i].line.segment.end);
    EXPECT_EQ(serial[i].line.sigma_q_px, parallel[i].line.sigma_q_px);
  }
}

TEST(ExtractSegments, ThePixelMapMovesTheLineNotItsPlaceInTheImage) {
  const cv::Mat image = normalised_image(white_from_column(50, 100));
  const PixelMap map = [](const Eigen::Vector2d& x) {
    return Eigen::Vector2d(2.0 * x.x() + 7.0, 2.0 * x.y());
  };
  const auto plain = extract_segments(image);
  const auto mapped = extract_segments(image, map);
  ASSERT_THAT(plain, SizeIs(1));
  ASSERT_THAT(mapped, SizeIs(1));
  EXPECT_EQ(plain[0].in_image.start, mapped[0].in_image.start);
  EXPECT_LT((*map(plain[0].line.segment.start) - mapped[0].line.segment.start).norm(), 1e-9);
}

TEST(ExtractSegments, EdgesOutsideOfTheFieldOfTheCalibrationAreLeftOut) {
  const PixelMap nowhere = [](const Eigen::Vector2d&) { return std::nullopt; };
  EXPECT_THAT(extract_segments(normalised_image(white_from_column(50, 100)), nowhere), IsEmpty());
}

TEST(ExtractSegments, RejectsOptionsOutOfRangeAndImagesThatAreNotNormalised) {
  const cv::Mat image = normalised_image(white_from_column(50, 100));
  ExtractOptions options;
  options.min_length_px = 0.0;
  EXPECT_THROW(extract_segments(image, {}, options), std::invalid_argument);
  EXPECT_THROW(extract_segments(cv::Mat()), std::invalid_argument);
  EXPECT_THROW(extract_segments(white_from_column(50, 100)), std::invalid_argument);
}

}  // namespace
}  // namespace ridgeline::reconstruct
