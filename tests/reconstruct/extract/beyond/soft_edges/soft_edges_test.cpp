// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/beyond/soft_edges/soft_edges.h"

#include "reconstruct/extract/beyond/extensions.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/scene/normalised_image.h"
#include "tests/reconstruct/extract/ok2011/blurred_scene.h"

#include <gmock/gmock.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

/// Standard deviations of the grey values in 0..1.
struct Disturbance {
  double texture = 0.035;
  double noise = 0.005;
};

/// Sides of six large roofs. The texture of roofs and ground is finer than the blur of the edges,
/// as compression and sharpening leave it.
test::BlurredScene soft_scene(double blur_px, std::uint64_t seed, const Disturbance& by = {}) {
  constexpr int kCell_px = 450;
  constexpr double kTextureBlur_px = 0.8;
  test::Random random(seed);
  cv::Mat image(2 * kCell_px, 3 * kCell_px, CV_64FC3, test::kGround);
  test::BlurredScene scene;
  for (int y = kCell_px / 2; y < image.rows; y += kCell_px) {
    for (int x = kCell_px / 2; x < image.cols; x += kCell_px) {
      test::Rectangle roof = test::random_rectangle({x, y}, 0.2, random);
      roof.half_length_px = random.uniform(100.0, 180.0);
      roof.half_width_px = random.uniform(60.0, 100.0);
      test::draw(roof, blur_px, image);
      test::add_edges(roof, scene.edges);
    }
  }
  cv::Mat texture(image.size(), CV_64FC1);
  for (auto& value : cv::Mat_<double>(texture)) value = random.normal(by.texture);
  cv::GaussianBlur(texture, texture, {}, kTextureBlur_px);
  cv::Mat bands;
  cv::merge(std::vector<cv::Mat>(3, texture), bands);
  image += bands;
  scene.raw = test::raw_image(image, by.noise, random);
  return scene;
}

constexpr double kSmoothing_px = ExtractOptions{}.gradient_sigma_px;

std::vector<EdgeSegment> extract_smoothed(const View& seen, double gradient_sigma_px) {
  ExtractionOptions options;
  options.edges.gradient_sigma_px = gradient_sigma_px;
  return extract_segments(seen.image, seen.ideal_from_image, options.edges,
                          edge_refinement(options));
}

std::vector<EdgeSegment> segments_of(const test::BlurredScene& scene, bool soft_edges) {
  View view;
  view.image = normalised_image(scene.raw);
  if (!soft_edges) return extract_smoothed(view, kSmoothing_px);
  return segments_at_common_size(std::array{&std::as_const(view)}, kSmoothing_px, extract_smoothed)
      .front();
}

/// Share of the edges of which one segment covers most, within 3 px of both its ends.
double share_found_whole(const test::BlurredScene& scene,
                         const std::vector<EdgeSegment>& segments) {
  constexpr double kMinCoveredShare = 0.75;
  constexpr double kBeside_px = 3.0;
  const auto is_whole = [&](const Segment2& edge) {
    return std::ranges::any_of(segments, [&](const EdgeSegment& segment) {
      const Segment2& s = segment.in_image;
      return length(s) > kMinCoveredShare * length(edge) && distance(edge, s.start) < kBeside_px &&
             distance(edge, s.end) < kBeside_px;
    });
  };
  return static_cast<double>(std::ranges::count_if(scene.edges, is_whole)) /
         static_cast<double>(scene.edges.size());
}

TEST(SoftEdges, OfASoftImageAreFoundAsAWhole) {
  const test::BlurredScene scene = soft_scene(5.0, 7);
  EXPECT_LT(share_found_whole(scene, segments_of(scene, false)), 0.3);
  EXPECT_GT(share_found_whole(scene, segments_of(scene, true)), 0.8);
}

TEST(SoftEdges, HaveACovarianceThatHolds) {
  std::vector<double> z2;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const test::BlurredScene scene = soft_scene(5.0, seed);
    const std::vector<EdgeSegment> segments = segments_of(scene, true);
    for (const test::EdgeError& error : test::edge_errors(scene.edges, segments)) {
      const double z = error.across_px / error.segment->line.sigma_q_px;
      z2.push_back(z * z);
    }
  }
  ASSERT_GT(z2.size(), 60U);
  // Chi-squared of one degree of freedom lies below 3.84 for 95 %; three sigma are left to the
  // share of so many edges.
  const auto n = static_cast<double>(z2.size());
  const double least = 0.95 - 3.0 * std::sqrt(0.95 * 0.05 / n);
  const auto n_inside = std::ranges::count_if(z2, [](double value) { return value < 3.84; });
  EXPECT_GT(static_cast<double>(n_inside) / n, least);
}

TEST(SoftEdges, LeaveTheTextureOut) {
  const test::BlurredScene scene = soft_scene(5.0, 7);
  const auto n_short = [&](bool soft_edges) {
    constexpr double kShort_px = 20.0;
    return std::ranges::count_if(segments_of(scene, soft_edges), [](const EdgeSegment& segment) {
      return length(segment.in_image) < kShort_px;
    });
  };
  EXPECT_LT(3 * n_short(true), n_short(false));
}

/// The smoothing of each search at full size.
std::vector<double> smoothing_of(const test::BlurredScene& scene) {
  View view;
  view.image = normalised_image(scene.raw);
  std::vector<double> smoothing_px;
  (void)segments_at_common_size(std::array{&std::as_const(view)}, kSmoothing_px,
                                [&](const View& seen, double gradient_sigma_px) {
                                  if (seen.image.size() == view.image.size())
                                    smoothing_px.push_back(gradient_sigma_px);
                                  return extract_smoothed(seen, gradient_sigma_px);
                                });
  return smoothing_px;
}

TEST(SoftEdges, AreSearchedWithAGradientSmoothedByThreeQuartersOfTheirBlur) {
  constexpr double kTolerance_px = 0.15;  // the blur is measured in steps of 0.05 to 0.2 px
  const test::BlurredScene soft = test::blurred_scene(3, {.blur_px = 2.6, .noise = 0.01});
  EXPECT_THAT(smoothing_of(soft),
              testing::ElementsAre(kSmoothing_px, testing::DoubleNear(0.75 * 2.6, kTolerance_px)));
  const test::BlurredScene sharp = test::blurred_scene(3, {.blur_px = 0.8, .noise = 0.01});
  EXPECT_THAT(smoothing_of(sharp), testing::ElementsAre(kSmoothing_px));
}

TEST(SoftEdges, WithoutTextureAreFoundAtFullSizeIfTheGradientIsSmoothedAsTheyAre) {
  double without = 0.0;
  double with = 0.0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const test::BlurredScene scene = soft_scene(3.0, seed, {.texture = 0.0, .noise = 0.02});
    const std::vector<EdgeSegment> segments = segments_of(scene, true);
    for (const EdgeSegment& segment : segments) EXPECT_EQ(segment.scale_px, 1.0);
    with += share_found_whole(scene, segments) / 3.0;
    without += share_found_whole(scene, segments_of(scene, false)) / 3.0;
  }
  EXPECT_LT(without, 0.8);
  EXPECT_GT(with, 0.95);
}

TEST(SoftEdges, LeaveASharpImageAsItIs) {
  const test::BlurredScene scene = soft_scene(0.8, 7);
  const std::vector<EdgeSegment> plain = segments_of(scene, false);
  const std::vector<EdgeSegment> with = segments_of(scene, true);
  ASSERT_EQ(with.size(), plain.size());
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_EQ(with[i].line.segment.start, plain[i].line.segment.start);
    EXPECT_EQ(with[i].scale_px, 1.0);
  }
}

/// The segments that are found in a view of 400 x 400 px at each factor, in pixels of that image.
struct FoundByFactor {
  std::vector<Segment2> at_1, at_2, at_3;

  [[nodiscard]] std::vector<EdgeSegment> in(const View& seen) const {
    const std::vector<Segment2>& found = seen.image.cols == 400   ? at_1
                                         : seen.image.cols == 200 ? at_2
                                         : seen.image.cols == 133 ? at_3
                                                                  : kNone;
    std::vector<EdgeSegment> edges;
    for (const Segment2& s : found) {
      EdgeSegment edge;
      edge.line = {s, midpoint(s), 0.1, 0.001, 1.0};
      edge.in_image = s;
      edges.push_back(edge);
    }
    return edges;
  }

  inline static const std::vector<Segment2> kNone{};
};

/// The scales of the segments of each view.
std::vector<std::vector<double>> scales_of(const std::vector<FoundByFactor>& found) {
  std::vector<View> views(found.size());
  std::vector<const View*> borrowed;
  for (std::size_t i = 0; i < views.size(); ++i) {
    views[i].id = std::to_string(i);
    views[i].image = cv::Mat::zeros(400, 400, CV_32FC1);
    borrowed.push_back(&views[i]);
  }
  const auto of_view = [&](const View& seen, double /*gradient_sigma_px*/) {
    return found[std::stoul(seen.id)].in(seen);
  };
  return transformed(segments_at_common_size(borrowed, kSmoothing_px, of_view),
                     [](const std::vector<EdgeSegment>& edges) {
                       return transformed(edges, &EdgeSegment::scale_px);
                     });
}

constexpr double kRow = 26.0 + 5.0 / 6.0;  // at 1/3, where row 40.5 at 1/2 is

TEST(SoftEdges, OfOneEdgeAreTakenFromTheFinestImageThatShowsItWhole) {
  const Segment2 in_3{{13.5, kRow}, {120.0, kRow}};
  const Segment2 in_2{{20.5, 40.5}, {180.5, 40.5}};  // the same edge
  const Segment2 other_in_2{{20.0, 100.0}, {180.0, 100.0}};
  const Segment2 other_in_3{{10.0, 110.0}, {60.0, 110.0}};
  EXPECT_THAT(scales_of({{.at_1 = {}, .at_2 = {in_2, other_in_2}, .at_3 = {in_3, other_in_3}}}),
              testing::ElementsAre(testing::ElementsAre(2.0, 2.0, 3.0)));
}

TEST(SoftEdges, OfPiecesAreTakenFromTheImageThatShowsThemAsOne) {
  const Segment2 in_3{{13.5, kRow}, {120.0, kRow}};
  const Segment2 first{{20.5, 40.5}, {70.0, 40.5}};
  const Segment2 second{{120.0, 40.5}, {170.0, 40.5}};
  const Segment2 elsewhere{{20.0, 100.0}, {175.0, 100.0}};
  EXPECT_THAT(scales_of({{.at_1 = {}, .at_2 = {first, second, elsewhere}, .at_3 = {in_3}}}),
              testing::ElementsAre(testing::ElementsAre(3.0, 2.0)));
}

TEST(SoftEdges, OfAllViewsHaveTheSizeThatIsBestForMostEdges) {
  const Segment2 in_1{{20.0, 20.0}, {380.0, 20.0}};
  const Segment2 in_2{{10.0, 50.0}, {190.0, 50.0}};
  const Segment2 other_in_2{{10.0, 150.0}, {190.0, 150.0}};
  const FoundByFactor sharp{.at_1 = {in_1}, .at_2 = {in_2}, .at_3 = {}};
  const FoundByFactor soft{.at_1 = {}, .at_2 = {in_2, other_in_2}, .at_3 = {}};
  EXPECT_THAT(scales_of({sharp, soft, soft}),
              testing::ElementsAre(testing::ElementsAre(2.0), testing::ElementsAre(2.0, 2.0),
                                   testing::ElementsAre(2.0, 2.0)));
  EXPECT_THAT(scales_of({sharp}), testing::ElementsAre(testing::ElementsAre(1.0)));
}

TEST(SoftEdges, AreNotFoundByFewSegments) {
  const Segment2 one_in_2{{20.5, 40.5}, {180.5, 40.5}};
  EXPECT_THAT(scales_of({{.at_1 = {{{10.0, 10.0}, {40.0, 10.0}}}, .at_2 = {one_in_2}, .at_3 = {}}}),
              testing::ElementsAre(testing::ElementsAre(1.0)));
}

}  // namespace
}  // namespace ridgeline::reconstruct
