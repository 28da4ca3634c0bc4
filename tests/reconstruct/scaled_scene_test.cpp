// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scaled_scene.h"

#include "reconstruct/reconstruct.h"
#include "tests/reconstruct/extract/ok2011/blurred_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ridgeline::reconstruct {
namespace {

/// Without texture, so that the edges are found at full size.
View view_blurred_by(double blur_px) {
  View view;
  view.image_from_local = ProjectionMatrix::Identity();
  view.image = test::blurred_scene(3, {.blur_px = blur_px, .noise = 0.01}).raw;
  extract({&view, 1});
  return view;
}

TEST(ScaleOfBlur, MakesPixelsAsLargeAsTheBlur) {
  EXPECT_EQ(scale_of_blur(view_blurred_by(0.8)), 1);
  EXPECT_EQ(scale_of_blur(view_blurred_by(2.0)), 2);
  EXPECT_EQ(scale_of_blur(view_blurred_by(3.0)), 3);
}

TEST(ScaleOfBlur, IsAtLeastTheScaleOfTheEdges) {
  View view = view_blurred_by(0.8);
  for (EdgeSegment& segment : view.segments) segment.scale_px = 2.0;
  EXPECT_EQ(scale_of_blur(view), 2);
}

TEST(AtScaleOfBlur, EdgesAreAsUncertainAsWhatLiesWithinTheirBlurMakesThem) {
  const Scene scene{{view_blurred_by(0.8), view_blurred_by(3.0)}, {0.0, 1.0}};
  const Scene scaled = at_scale_of_blur(scene, std::array{1, 3});
  const auto line = [](const View& view) { return view.segments.front().line; };
  EXPECT_EQ(line(scaled.views[0]).sigma_q_px, line(scene.views[0]).sigma_q_px);
  const UncertainSegment2 soft = line(scene.views[1]);
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(line(scaled.views[1]).sigma_q_px, std::hypot(soft.sigma_q_px / 3.0, 0.2), kRounding);
  EXPECT_NEAR(line(scaled.views[1]).sigma_phi_rad,
              std::hypot(soft.sigma_phi_rad, 0.15 / (length(soft.segment) / 6.0)), kRounding);
}

}  // namespace
}  // namespace ridgeline::reconstruct
