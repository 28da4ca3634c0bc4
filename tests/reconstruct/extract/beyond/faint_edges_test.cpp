// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/beyond/faint_edges.h"

#include "reconstruct/extract/beyond/extensions.h"
#include "reconstruct/scene/normalised_image.h"
#include "tests/reconstruct/extract/ok2011/blurred_scene.h"

#include <gmock/gmock.h>

namespace ridgeline::reconstruct {
namespace {

test::ErrorSummary errors_of(const test::BlurredScene& scene, bool faint_edges) {
  EdgeExtensionOptions beyond{.junction_cuts = false, .separate_edges = false};
  beyond.faint_edges = faint_edges;
  const auto segments =
      extract_segments(normalised_image(scene.raw), {}, {}, edge_refinement({{}, beyond}));
  return test::summary(test::edge_errors(scene.edges, segments), scene.edges);
}

TEST(WithFaintEdges, FindsFaintEdgesAsAccurately) {
  // the steps are twice the noise
  const test::BlurredScene scene = test::blurred_scene(5, {.noise = 0.01, .contrast = 0.02});
  const test::ErrorSummary two_appearances = errors_of(scene, true);
  const test::ErrorSummary one_appearance = errors_of(scene, false);
  EXPECT_LT(one_appearance.completeness, 0.5);
  EXPECT_GT(two_appearances.completeness, 0.7);
  EXPECT_LT(two_appearances.rms_px, 1.1 * one_appearance.rms_px);
  EXPECT_LT(two_appearances.across_z2, 1.0);  // the systematic part of the sigma has reserves
}

TEST(WithFaintEdges, LeavesClearEdgesAsTheyAre) {
  const test::BlurredScene scene = test::blurred_scene(5, {.noise = 0.01, .contrast = 0.2});
  const test::ErrorSummary two_appearances = errors_of(scene, true);
  const test::ErrorSummary one_appearance = errors_of(scene, false);
  EXPECT_EQ(two_appearances.rms_px, one_appearance.rms_px);
  EXPECT_EQ(two_appearances.completeness, one_appearance.completeness);
}

TEST(WithFaintEdges, LooksOnceAtAnImageWhoseFirstLookIsAsSmooth) {
  const test::BlurredScene scene = test::blurred_scene(5, {.noise = 0.01, .contrast = 0.02});
  const ImagePart image(normalised_image(scene.raw));
  const auto n_found = [&](double first_sigma_px) {
    ExtractionOptions options;
    options.edges.gradient_sigma_px = first_sigma_px;
    return with_faint_edges({}, image, options).size();
  };
  EXPECT_GT(n_found(0.8), 0U);
  EXPECT_EQ(n_found(1.5), 0U);
}

}  // namespace
}  // namespace ridgeline::reconstruct
