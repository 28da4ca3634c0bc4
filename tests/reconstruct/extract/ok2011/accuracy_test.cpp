// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/extract_segments.h"
#include "reconstruct/scene/normalised_image.h"
#include "tests/reconstruct/extract/ok2011/blurred_scene.h"

#include <Eigen/Dense>
#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

/// Found edges of three scenes, 144 rectangles.
struct Found {
  std::vector<std::vector<EdgeSegment>> segments;  ///< which the errors point to
  std::vector<test::EdgeError> errors;
  std::vector<Segment2> edges;
};

Found found_edges(const test::BlurredSceneOptions& scene_options) {
  ExtractOptions options;
  options.systematic_across_px = 0.01;  // these edges are as simple as the model
  Found found;
  for (const std::uint64_t seed : {101, 102, 103, 104}) {
    const test::BlurredScene scene = test::blurred_scene(seed, scene_options);
    found.segments.push_back(extract_segments(normalised_image(scene.raw), {}, options));
    const auto errors = test::edge_errors(scene.edges, found.segments.back());
    found.errors.insert(found.errors.end(), errors.begin(), errors.end());
    found.edges.insert(found.edges.end(), scene.edges.begin(), scene.edges.end());
  }
  return found;
}

/// Shift of all segments together in x and y, which does not depend on the side that is bright.
Eigen::Vector2d common_shift_px(const std::vector<test::EdgeError>& errors) {
  Eigen::Matrix2d normal_matrix = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right_side = Eigen::Vector2d::Zero();
  for (const test::EdgeError& e : errors) {
    normal_matrix += e.normal * e.normal.transpose();
    right_side += e.across_px * e.normal;
  }
  return normal_matrix.ldlt().solve(right_side);
}

TEST(Accuracy, EdgesOfGoodContrastAreFoundToAFewHundredthsOfAPixel) {
  for (const double blur_px : {0.5, 0.8, 1.2}) {
    const Found found = found_edges({.blur_px = blur_px});
    const test::ErrorSummary s = test::summary(found.errors, found.edges);
    EXPECT_LT(s.rms_px, 0.05) << blur_px;
    EXPECT_LT(std::abs(s.bias_px), 0.005) << blur_px;
    EXPECT_LT(common_shift_px(found.errors).norm(), 0.005) << blur_px;
    EXPECT_GT(s.completeness, 0.88) << blur_px;  // 2 px at each corner are rounded
  }
}

TEST(Accuracy, StatedSigmasAreThoseOfTheErrors) {
  // this noise outweighs the systematic part of the sigmas
  const Found found = found_edges({.blur_px = 0.8, .noise = 0.02});
  const test::ErrorSummary s = test::summary(found.errors, found.edges);
  // 15.16 of the specification asks for 10 % of sigma, 20 % of the variance
  EXPECT_NEAR(s.across_z2, 1.0, 0.2);
  EXPECT_NEAR(s.angle_z2, 1.0, 0.2);
}

TEST(Accuracy, EdgesNear45DegreesAreFoundOverTheirLength) {
  constexpr double kCorners_px = 6.0;  // 2 px at each are rounded, and the noise
  for (const std::uint64_t seed : {111, 112, 113}) {
    const test::BlurredScene scene = test::diagonal_scene(seed, {.noise = 0.02, .size_px = 150});
    const auto segments = extract_segments(normalised_image(scene.raw));
    for (const Segment2& edge : scene.edges) {
      double found_px = 0.0;
      for (const test::EdgeError& error : test::edge_errors({edge}, segments)) {
        found_px += error.length_px;
        EXPECT_LT(std::abs(error.across_px), 0.2);
      }
      EXPECT_NEAR(found_px, length(edge), kCorners_px) << seed << ": " << edge.start.transpose();
    }
  }
}

TEST(Accuracy, FaintEdgesAreFoundInNoise) {
  // the step is three times the noise of a pixel in each band
  const Found found = found_edges({.noise = 0.02, .contrast = 0.06});
  const test::ErrorSummary s = test::summary(found.errors, found.edges);
  EXPECT_GT(s.completeness, 0.7);
  EXPECT_LT(s.rms_px, 0.2);
}

}  // namespace
}  // namespace ridgeline::reconstruct
