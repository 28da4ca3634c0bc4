// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/photograph.h"

#include "apps/simulate/edge_contrast.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>
#include <opencv2/core.hpp>

#include <algorithm>

namespace ridgeline::simulate {
namespace {

/// A frame of more than twice the rows that come at once, at 0.2 m a pixel. The house and its
/// ground are a third as wide.
FlightOptions small_frame() {
  FlightOptions flight;
  flight.focal_length_px = 4000.0;
  flight.base_to_height = 0.05;
  flight.frame_px = Eigen::Vector2i(640, 1300);
  return flight;
}

RenderOptions two_by_two_rays() {
  RenderOptions options;
  options.samples_per_side = 2;
  return options;
}

bool same_bytes(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

TEST(Photograph, OfAFrameIsTheWholeImageByTheByteForAnyNumberOfThreads) {
  const SyntheticScene scene = test::gabled_house(35.0, 20.0);
  const Renderer renderer(scene, two_by_two_rays());
  const AerialView view = aerial_views(scene, small_frame()).back();
  const cv::Mat radiance = renderer.radiance(view);
  const SensorOptions degraded{.blur_px = 2.2, .bayer = true, .jpeg_quality = 60};
  for (const SensorOptions& options : {SensorOptions{}, degraded}) {
    const cv::Mat whole = expose(radiance, options, view.number);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    cv::Mat streamed;
    int most_rows = 0;
    const ImageWindow village = photograph(renderer, view, options, [&](const cv::Mat& rows) {
      streamed.push_back(rows);
      most_rows = std::max(most_rows, rows.rows);
    });
    EXPECT_TRUE(same_bytes(streamed, whole)) << options.jpeg_quality;
    EXPECT_EQ(most_rows, kRowsAtOnce);
    ASSERT_FALSE(village.pixels.empty());
    EXPECT_LT(village.pixels.total(), whole.total() / 4);
    const cv::Rect shown(village.corner_px.x(), village.corner_px.y(), village.pixels.cols,
                         village.pixels.rows);
    EXPECT_TRUE(same_bytes(village.pixels, whole(shown)));
  }
}

TEST(Photograph, OfAnImageAroundThePlanReturnsAllOfItWithAllRays) {
  const SyntheticScene scene = test::gabled_house(35.0, 20.0);
  const Renderer renderer(scene, two_by_two_rays());
  FlightOptions flight;
  flight.focal_length_px = 4000.0;
  flight.margin_m = 20.0;  // most is beyond the plan, and has all rays
  const AerialView view = aerial_views(scene, flight).front();
  const ImageWindow all = photograph(renderer, view, {}, [](const cv::Mat&) {});
  AerialView with_all_rays =
      view;  // of the pixels beside the image, whose light spreads into it, too
  with_all_rays.village_px = {Eigen::Vector2i(-100, -100),
                              view.size_px + Eigen::Vector2i(100, 100)};
  EXPECT_TRUE(same_bytes(all.pixels, expose(renderer.radiance(with_all_rays), {}, view.number)));
}

/// Mean and standard deviation of the green band.
std::pair<double, double> green(const cv::Mat& image) {
  cv::Scalar mean;
  cv::Scalar sigma;
  cv::meanStdDev(image, mean, sigma);
  return {mean[1], sigma[1]};
}

TEST(Photograph, FillsAFrameWithTheLawnThatLiesAroundTheVillage) {
  const SyntheticScene scene = test::flat_house();
  const Renderer renderer(scene, two_by_two_rays());
  const AerialView frame = aerial_views(scene, small_frame()).front();
  cv::Mat image;
  (void)photograph(renderer, frame, {}, [&](const cv::Mat& rows) { image.push_back(rows); });
  // the same ground with all rays: around the plan, where no mesh is
  AerialView dense = frame;
  dense.village_px = {Eigen::Vector2i::Zero(), frame.size_px - Eigen::Vector2i::Ones()};
  const cv::Mat all_rays = expose(renderer.radiance(dense, 0, 300), {}, frame.number);
  const auto [mean, sigma] = green(image.rowRange(0, 300));
  const auto [dense_mean, dense_sigma] = green(all_rays);
  EXPECT_GT(sigma, 3.0);  // it has texture
  EXPECT_NEAR(mean, dense_mean, 0.5);
  EXPECT_NEAR(sigma / dense_sigma, 1.0, 0.25);  // one ray sees the finest texture sharper
  EXPECT_NEAR(green(image.rowRange(1000, 1300)).first, mean, 10.0);  // dry spots
}

TEST(ContrastAcross, IsThatOfTheImageInAWindowOfIt) {
  cv::Mat image(60, 80, CV_8UC3);
  cv::randu(image, cv::Scalar::all(0), cv::Scalar::all(255));
  const cv::Rect part(21, 13, 40, 30);
  const ImageWindow window{image(part), {part.x, part.y}};
  const Segment2 segment{{25.3, 17.9}, {55.2, 38.4}};
  EXPECT_EQ(contrast_across(window, segment), contrast_across({image}, segment));
}

}  // namespace
}  // namespace ridgeline::simulate
